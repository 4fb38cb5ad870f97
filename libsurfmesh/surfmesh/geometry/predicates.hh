// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/core/values.hh"

namespace surfmesh {

namespace detail {

/// Sign of orient2d in exact arithmetic.
int orient2d_exact(Uv a, Uv b, Uv c);

/// (3 + 16 ε) ε with ε = 2⁻⁵³: the rounding error of the determinant in orient2d is below this
/// share of the sum of its terms' magnitudes.
/// Source   Shewchuk, Adaptive precision floating-point arithmetic (1997), section 4.3
inline constexpr double kOrientErrorBound = 3.3306690738754716e-16;

/// Sign of orient3d in exact arithmetic.
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// (7 + 56 ε) ε: likewise for orient3d.
/// Source   Shewchuk, Adaptive precision floating-point arithmetic (1997), section 4.3
inline constexpr double kOrient3dErrorBound = 7.771561172376103e-16;

}  // namespace detail

/// Exact sign of the area of (a,b,c): 1 counter-clockwise, -1 clockwise, 0 collinear or not finite.
///
/// A cyclic shift of the arguments keeps the sign, an exchange of two inverts it. Exact as long as
/// no product over- or underflows.
inline int orient2d(Uv a, Uv b, Uv c) {
  const double left = (a.u - c.u) * (b.v - c.v);
  const double right = (a.v - c.v) * (b.u - c.u);
  const double determinant = left - right;
  const double bound = detail::kOrientErrorBound * (std::abs(left) + std::abs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  if (bound == 0) return 0;
  return detail::orient2d_exact(a, b, c);
}

/// Exact sign of the volume of (a,b,c,d): 1 if (a,b,c) runs counter-clockwise as seen from d, -1 if
/// clockwise, 0 if all lie in a plane or one is not finite.
///
/// Any exchange of two arguments inverts the sign. Exact as long as no product over- or underflows.
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 from_a = a - d, from_b = b - d, from_c = c - d;
  const double bc = from_b.x() * from_c.y(), cb = from_c.x() * from_b.y();
  const double ca = from_c.x() * from_a.y(), ac = from_a.x() * from_c.y();
  const double ab = from_a.x() * from_b.y(), ba = from_b.x() * from_a.y();
  const double determinant =
      from_a.z() * (cb - bc) + from_b.z() * (ac - ca) + from_c.z() * (ba - ab);
  const double magnitude = std::abs(from_a.z()) * (std::abs(bc) + std::abs(cb)) +
                           std::abs(from_b.z()) * (std::abs(ca) + std::abs(ac)) +
                           std::abs(from_c.z()) * (std::abs(ab) + std::abs(ba));
  const double bound = detail::kOrient3dErrorBound * magnitude;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  if (bound == 0) return 0;
  return detail::orient3d_exact(a, b, c, d);
}

}  // namespace surfmesh
