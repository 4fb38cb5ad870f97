// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh::detail {

/// The vertex of a corner.
inline Vec3 point_of(const PolyMesh& mesh, HalfedgeHandle corner) {
  return to_eigen(mesh.point(mesh.to_vertex_handle(corner)));
}

/// The corners of a face, as the halfedges that lead to them.
inline std::vector<HalfedgeHandle> corners_of(const PolyMesh& mesh, FaceHandle fh) {
  std::vector<HalfedgeHandle> corners;
  const HalfedgeHandle start = mesh.halfedge_handle(fh);
  HalfedgeHandle heh = start;
  do {
    corners.push_back(heh);
    heh = mesh.next_halfedge_handle(heh);
  } while (heh != start);
  return corners;
}

/// Twice the area of a polygon, along its normal.
inline Vec3 double_area_of(const PolyMesh& mesh, const std::vector<HalfedgeHandle>& corners) {
  const Vec3 a = point_of(mesh, corners[0]);
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) {
    area += (point_of(mesh, corners[k - 1]) - a).cross(point_of(mesh, corners[k]) - a);
  }
  return area;
}

inline Vec3 middle_of(const PolyMesh& mesh, const std::vector<HalfedgeHandle>& corners) {
  Vec3 sum = Vec3::Zero();
  for (const HalfedgeHandle corner : corners) sum += point_of(mesh, corner);
  return sum / static_cast<double>(corners.size());
}

}  // namespace surfmesh::detail
