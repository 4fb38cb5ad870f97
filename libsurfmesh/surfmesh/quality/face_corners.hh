// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
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

/// Call a function for each triangle that a face is taken to consist of, with its three corners:
/// those of a fan around the first corner.
template <class Corner, class Visit>
void visit_triangles(const std::vector<Corner>& corners, const Visit& visit) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    visit(std::array<Corner, 3>{corners[0], corners[k - 1], corners[k]});
  }
}

/// The same for each triangle that a face may be taken to consist of: of a quad, those at either
/// diagonal.
template <class Corner, class Visit>
void visit_possible_triangles(const std::vector<Corner>& corners, const Visit& visit) {
  visit_triangles(corners, visit);
  if (corners.size() != 4) return;
  visit(std::array<Corner, 3>{corners[1], corners[2], corners[3]});
  visit(std::array<Corner, 3>{corners[1], corners[3], corners[0]});
}

/// The vertices of a triangle.
inline std::array<Vec3, 3> points_of(const PolyMesh& mesh,
                                     const std::array<HalfedgeHandle, 3>& corners) {
  return {point_of(mesh, corners[0]), point_of(mesh, corners[1]), point_of(mesh, corners[2])};
}

/// Twice the area of a polygon, along its normal.
inline Vec3 double_area_of(const PolyMesh& mesh, const std::vector<HalfedgeHandle>& corners) {
  Vec3 area = Vec3::Zero();
  visit_triangles(corners, [&](const std::array<HalfedgeHandle, 3>& triangle) {
    const auto [a, b, c] = points_of(mesh, triangle);
    area += (b - a).cross(c - a);
  });
  return area;
}

inline Vec3 middle_of(const PolyMesh& mesh, const std::vector<HalfedgeHandle>& corners) {
  Vec3 sum = Vec3::Zero();
  for (const HalfedgeHandle corner : corners) sum += point_of(mesh, corner);
  return sum / static_cast<double>(corners.size());
}

}  // namespace surfmesh::detail
