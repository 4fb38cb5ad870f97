// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "surfmesh/pieces/mesh_piece.hh"
#include "surfmesh/pieces/piece_builder.hh"
#include "surfmesh/pieces/shared_numbers.hh"
#include "surfmesh/pieces/tile_summary.hh"

namespace surfmesh {

/// By tile the id of the first of its own vertices, and behind the last one the number of vertices
/// of the whole mesh: shared vertices come first.
std::vector<std::int64_t> first_own_ids(const std::vector<TileSummary>& tiles,
                                        const SharedNumbers& shared);

/// Give the vertices of a piece their ids in the whole mesh, those on contours the positions that
/// all patches see alike, and tell which other pieces have them, too. `first_own` is that of
/// first_own_ids.
/// Cost     O(vertices of the piece)
MeshPiece numbered(PieceBuilder builder, int piece, const SharedNumbers& shared,
                   const std::vector<std::int64_t>& first_own);

}  // namespace surfmesh
