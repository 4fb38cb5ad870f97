// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "surfmesh/core/values.hh"

/// How faces lie to their surface: one rule for meshing and for checks.
namespace surfmesh {

/// Area below this share of the squared longest side is rounding: coordinates have errors near
/// 1e-16 of their size.
inline constexpr double kFlat = 1e-14;

/// True if a face has no area.
///
/// `double_area` is the length of its normal, as a cross product gives it.
inline bool is_flat(double double_area, double squared_longest_side) {
  return !(double_area > kFlat * squared_longest_side);
}

/// The cosine of the angle between a face and its surface: below 0 if it is turned. 0 without a
/// normal.
///
/// `area` is the face's normal, as a cross product gives it, and `normals` the sum of the normals
/// p_u × p_v of the surface at its corners, not of unit length: their mean is the area vector of
/// the piece of surface, by the area in parameters. A corner without a tangent plane adds none.
inline double facing(const Vec3& area, const Vec3& normals) {
  return area.stableNormalized().dot(normals.stableNormalized());
}

/// True if a triangle is turned against the normals of its surface, or has no area.
inline bool is_turned(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normals) {
  const Vec3 area = (b - a).cross(c - a);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return facing(area, normals) <= 0 || is_flat(area.norm(), longest);
}

}  // namespace surfmesh
