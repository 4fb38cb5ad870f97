// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/values.hh"
#include "view/page_arrays.hh"

namespace surfmesh {

/// Where the numbers of a page count from, so that single precision is enough for them.
struct PageOrigins {
  Vec3 centre = Vec3::Zero();  ///< of the box of the mesh
  double radius = 1;           ///< half of its diagonal, never 0
  std::vector<Uv> of_patches;  ///< the least u and v of the corners of each patch
};

/// Throws   InvalidInput where a face has a patch of so great a number that no mesh has as many:
/// the
///          page takes room for all patches up to it
void check_patch_numbers(const PolyMesh& mesh, const MeshNames& names);

/// Infinite and unset positions and parameters are left out.
PageOrigins page_origins(const PolyMesh& mesh);

/// Add the mesh itself.
///
/// points        x, y, z of each vertex, from the centre and as shares of the radius
/// corners       a node for each corner, face by face. Nodes are the vertices, and after them
///               those that a vertex has besides, for another patch or other values at its corners
/// extra         the vertex of each further node
/// sizes         the number of corners of each face; left out for triangles only
/// patch         of each face, if faces have one
/// uv            u, v of each node, from the origin of the patch, if corners have them
/// metric        m11, m12, m22 of each node, if corners have it
/// lines         pairs of vertices: the contour_edges of pictures
/// line_contour  the contour of each of them, -1 for none, if the mesh has contours
void add_mesh(const PolyMesh& mesh, const PageOrigins& origins, PageArrays& arrays);

}  // namespace surfmesh
