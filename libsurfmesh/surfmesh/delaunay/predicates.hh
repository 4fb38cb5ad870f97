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

}  // namespace surfmesh
