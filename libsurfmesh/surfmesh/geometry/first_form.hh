// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// The first fundamental form's factor from the first derivatives of a surface.
/// Source   paper, eq. (2)
inline FirstFormFactor first_form_factor(const Vec3& du, const Vec3& dv) {
  const double l11 = du.norm();
  if (l11 == 0) return {0, dv.norm(), 0};
  const double l21 = du.dot(dv) / l11;
  // |du × dv| / |du| is √(G − F²/E) without its cancellation.
  return {l11, l21, du.cross(dv).norm() / l11};
}

/// A point of a patch with the surface values that a query of sizes reads.
struct SurfacePoint {
  Uv uv;
  Vec3 point;
  FirstFormFactor form;
};

/// Sine of the angle between p_u and p_v below which they count as parallel: the cross product has
/// rounding errors near 1e-16 |p_u| |p_v|, so a normal still has about four digits here.
inline constexpr double kSmallestSine = 1e-12;

/// True if the surface has a tangent plane: p_u and p_v are finite, not zero and not parallel.
inline bool is_regular(const FirstFormFactor& p) {
  // l22 = sin, l21 = cos of the angle, times |p_v|: where the sine is small the cosine is nearly 1.
  return p.l11 > 0 && p.l22 > kSmallestSine * std::max(std::abs(p.l21), p.l22);
}

/// Squared length in space of a parameter step, to first order.
inline double squared_distance(const FirstFormFactor& p, Uv step) {
  const double x = p.l11 * step.u + p.l21 * step.v, y = p.l22 * step.v;
  return x * x + y * y;
}

}  // namespace surfmesh
