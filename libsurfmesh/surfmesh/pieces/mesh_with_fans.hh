// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh::detail {

/// A copy of the mesh of a tile with the faces around its poles, behind all others. Each fan has a
/// vertex of its own at its pole.
///
/// Reads    surf:uv, surf:metric (halfedge), surf:patch (face) of the tile's mesh
/// Writes   the same, for the new faces as in the result of assemble()
/// Cost     O(faces)
std::unique_ptr<PolyMesh> mesh_with_fans(const PatchMesh& tile, const Model& model);

}  // namespace surfmesh::detail
