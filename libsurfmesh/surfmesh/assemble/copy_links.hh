// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Link the faces of a piece in the result. Open halfedges are not linked.
///
/// Different pieces write to different elements, so that all may be written at once.
///
/// Cost     O(n)
/// Pre      place_edges has been called
void copy_links(const Piece& piece, const CommonVertices& common, PolyMesh& result);

}  // namespace surfmesh::detail
