// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "formats/example_meshes.hh"
#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// Names of the patches and contours of named_example: with blanks, quotes and umlauts, and some
/// that are not there.
inline MeshNames example_names() {
  return {
      {"left \"wing\" \xC3\xBC", ""}, {{"all of it", {0, 1}}, {"it's one", {0}}}, {"", "the rim"}};
}

/// A wavy grid whose faces below the middle are patch 0, above it patch 1. The line between them is
/// contour 0, the border contour 1. Corners have (u,v), plain (x,y) in patch 0 and (y,x) in patch
/// 1, and the metric that asks for 0.25 in all directions of the plane.
inline PolyMesh named_example(int quad_every, int n = 4) {
  PolyMesh mesh = wavy_grid(n, quad_every);
  const auto patch = attach(mesh, keys::face_patch, 0);
  const auto contour = attach(mesh, keys::edge_contour, -1);
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  const double middle = n / 2 / 7.0;
  for (const FaceHandle fh : mesh.faces()) {
    double y = 0;
    for (const VertexHandle vh : mesh.fv_range(fh)) y += mesh.point(vh)[1] - middle;
    mesh.property(patch, fh) = y < 0 ? 0 : 1;
  }
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    const OpenMesh::Vec3d& p = mesh.point(mesh.to_vertex_handle(heh));
    const bool is_first = mesh.property(patch, mesh.face_handle(heh)) == 0;
    mesh.property(uv, heh) = is_first ? Uv{p[0], p[1]} : Uv{p[1], p[0]};
    mesh.property(metric, heh) = {16, 0, 16};
  }
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    if (mesh.is_boundary(eh)) {
      mesh.property(contour, eh) = 1;
    } else if (mesh.property(patch, mesh.face_handle(heh)) !=
               mesh.property(patch, mesh.opposite_face_handle(heh))) {
      mesh.property(contour, eh) = 0;
    }
  }
  return mesh;
}

}  // namespace surfmesh
