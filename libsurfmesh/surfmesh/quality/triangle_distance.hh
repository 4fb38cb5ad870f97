// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

struct TriangleDistance {
  double distance = 0;
  bool is_inside = false;  ///< the nearest point is not on a side of the triangle
};

/// The distance of a point from a triangle, which may have no area.
TriangleDistance triangle_distance(const Vec3& point, const std::array<Vec3, 3>& triangle);

}  // namespace surfmesh::detail
