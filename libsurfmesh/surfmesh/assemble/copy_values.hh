// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/piece.hh"
#include "surfmesh/assemble/result_arrays.hh"

namespace surfmesh::detail {

/// Write what the corners and faces of a piece hold to the result, and the points of the piece's
/// own vertices and of those between the pieces of a patch.
///
/// Different pieces write to different elements, so that all may be written at once.
///
/// Cost     O(n)
/// Pre      place_edges has been called
void copy_values(const Piece& piece, const CommonVertices& common, const ResultArrays& result);

/// Free the points and properties of a piece's mesh; its links stay.
void release_values(PolyMesh& mesh);

}  // namespace surfmesh::detail
