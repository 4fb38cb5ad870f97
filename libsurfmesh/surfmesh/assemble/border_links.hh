// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/assemble/piece.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh::detail {

/// Link the open halfedges of a mesh whose faces are linked already.
///
/// `sides` are all halfedges of faces whose opposites may be open.
///
/// Cost     O(sides × faces around a vertex)
void link_open_halfedges(const std::vector<HalfedgeHandle>& sides, PolyMesh& mesh);

/// Give every fan of faces around a vertex a vertex of its own. The fan that has the first corner
/// of a face in the order of the faces keeps the old one, the others get new ones in that order,
/// with equal points.
///
/// `sides` and their `halfedges` are those at the border of pieces: faces around a vertex are parts
/// of one fan unless such a side parts them.
///
/// Cost     O(sides × faces around a vertex)
void separate_fans(const std::vector<BorderSide>& sides,
                   const std::vector<HalfedgeHandle>& halfedges, PolyMesh& mesh);

}  // namespace surfmesh::detail
