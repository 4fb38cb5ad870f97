// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Angles between the faces of a mesh; for sources of this folder only.

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// Degrees of a radian.
inline constexpr double kDegrees = 180 / std::numbers::pi;

/// The angle between two vectors of any length, radians; 0 if one of them is zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Twice the area of a polygon along its normal. `point_of` tells the point of a vertex.
template <class Face, class PointOf>
Vec3 area_vector(const Face& face, PointOf point_of) {
  using Index = decltype(face.size());
  Vec3 area = Vec3::Zero();
  for (Index k = 2; k < face.size(); ++k) {
    const Vec3 first = point_of(face[0]);
    area += (point_of(face[k - 1]) - first).cross(point_of(face[k]) - first);
  }
  return area;
}

/// The same for a face of points.
template <class Face>
Vec3 area_vector(const Face& face, const std::vector<Vec3>& points) {
  return area_vector(face,
                     [&](int v) -> const Vec3& { return points[static_cast<std::size_t>(v)]; });
}

}  // namespace surfmesh::detail
