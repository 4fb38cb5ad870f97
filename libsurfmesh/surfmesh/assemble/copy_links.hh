// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Link the faces of a piece in the result. Open halfedges are not linked.
///
/// Different pieces write to different elements, so that all may be written at once.
///
/// Cost     O(n), and O(m log m) of m elements at the border
void copy_links(const Piece& piece, const CommonVertices& common, PolyMesh& result);

}  // namespace surfmesh::detail
