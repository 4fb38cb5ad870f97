// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Check that a domain is finite and that u0 < u1 and v0 < v1.
/// Throws   InvalidInput, naming the bounds
void check(const Domain& domain);

/// Report an evaluation that is not finite, up to the requested order.
/// Throws   Geometry, naming (u,v), the order and the coordinates, always
[[noreturn]] void throw_not_finite(const Jet& jet, Uv uv, Order order);

/// Check the result of an evaluation, up to the requested order.
/// Throws   Geometry if it is not finite, naming (u,v)
inline void check_finite(const Jet& jet, Uv uv, Order order) {
  // x − x is 0 for every finite x, else NaN, which no sum loses.
  double sum = (jet.point - jet.point).sum();
  if (order >= Order::First) sum += (jet.du - jet.du).sum() + (jet.dv - jet.dv).sum();
  if (order >= Order::Second) {
    sum += (jet.duu - jet.duu).sum() + (jet.duv - jet.duv).sum() + (jet.dvv - jet.dvv).sum();
  }
  if (!(sum == 0)) throw_not_finite(jet, uv, order);
}

}  // namespace surfmesh
