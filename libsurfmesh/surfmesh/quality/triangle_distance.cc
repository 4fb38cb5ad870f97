// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_distance.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surfmesh/geometry/segment_distance.hh"

namespace surfmesh::detail {

TriangleDistance triangle_distance(const Vec3& point, const std::array<Vec3, 3>& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  bool is_inside = normal.squaredNorm() > 0;
  double nearest = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
    is_inside = is_inside && normal.dot((b - a).cross(point - a)) > 0;
    nearest = std::min(nearest, segment_distance(point, a, b));
  }
  if (!is_inside) return {nearest, false};
  return {std::abs(normal.dot(point - triangle[0])) / normal.norm(), true};
}

}  // namespace surfmesh::detail
