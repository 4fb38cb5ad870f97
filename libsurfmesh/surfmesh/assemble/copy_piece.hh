// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/piece.hh"
#include "surfmesh/assemble/result_arrays.hh"

namespace surfmesh::detail {

/// Write the faces of a piece to the result: their links, parameters and metrics, and the points of
/// the piece's own vertices and of those between the pieces of a patch. Open halfedges are not
/// linked.
///
/// Different pieces write to different elements, so that all may be written at once.
///
/// `number` is the piece's own, `halfedges` are those that glued sides have got, by the piece's
/// list of sides.
///
/// Cost     O(n), and O(m log m) of m elements at the border
void copy_piece(const Piece& piece, int number, const CommonVertices& common,
                std::span<const HalfedgeHandle> halfedges, ResultArrays& result);

}  // namespace surfmesh::detail
