// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/glue_sides.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// What the handles of a half-edge mesh can count: 2^30 - 1 edges, of two half-edges each, and 2^31
/// - 1 vertices.
/// Throws   Limit if there are more
void check_counts_of_mesh(std::size_t vertices, std::size_t edges);

/// Take the meshes of patches as pieces, and number their vertices: those that pieces share come
/// first, as NodeNumbers has them, then each piece's own.
/// Throws   as check_counts_of_mesh; edges between patches count for both
std::vector<Piece> take_pieces(std::vector<PatchMesh> patches, const PatchOrientation& orientation,
                               const NodeNumbers& numbers);

/// Number the faces of the pieces, and the edges that are copied: each piece's follow those of the
/// piece before it.
/// Pre      survey_border has been called for all pieces
/// Returns  the counts of all pieces together
ElementCounts number_elements(std::vector<Piece>& pieces);

/// The sides at the borders of all pieces, in their order.
std::vector<BorderSide> sides_of(const std::vector<Piece>& pieces);

/// Give the sides of glued edges their halfedges, by side: these edges come from `first_edge` on.
/// The pieces get their parts of the list.
std::vector<HalfedgeHandle> give_halfedges(const GluedSides& glued, std::size_t first_edge,
                                           std::vector<Piece>& pieces);

}  // namespace surfmesh::detail
