// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/difference_surface.hh"

#include <algorithm>

namespace surfmesh {
namespace {

/// Share of the domain's width: near the fourth root of the rounding error of a position, which is
/// where truncation and rounding of second derivatives balance.
constexpr double kStep = 1.0 / 4096;

/// The place nearest to a point around which the whole stencil lies in the domain.
Uv stencil_centre(const Domain& domain, Uv uv, double step_u, double step_v) {
  Uv centre = {std::clamp(uv.u, domain.u0 + step_u, domain.u1 - step_u),
               std::clamp(uv.v, domain.v0 + step_v, domain.v1 - step_v)};
  if (domain.shape == Domain::Shape::Triangle) {
    const double s = (centre.u - domain.u0) / (domain.u1 - domain.u0);
    const double t = (centre.v - domain.v0) / (domain.v1 - domain.v0);
    const double beyond = std::max(0.0, s + t + 2 * kStep - 1);
    centre = domain.at(s - 0.5 * beyond, t - 0.5 * beyond);
  }
  return centre;
}

}  // namespace

Jet DifferenceSurface::evaluate(Uv uv, Order order) const {
  Jet jet;
  jet.point = at(uv.u, uv.v);
  if (order == Order::Position) return jet;
  const Domain domain = surface_.domain();
  const double a = kStep * (domain.u1 - domain.u0), b = kStep * (domain.v1 - domain.v0);
  const auto [u, v] = stencil_centre(domain, uv, a, b);
  const Vec3 left = at(u - a, v), right = at(u + a, v), below = at(u, v - b), above = at(u, v + b);
  jet.du = (right - left) / (2 * a);
  jet.dv = (above - below) / (2 * b);
  if (order == Order::First) return jet;
  const Vec3 middle = at(u, v);
  jet.duu = (right - 2 * middle + left) / (a * a);
  jet.dvv = (above - 2 * middle + below) / (b * b);
  jet.duv =
      (at(u + a, v + b) - at(u + a, v - b) - at(u - a, v + b) + at(u - a, v - b)) / (4 * a * b);
  return jet;
}

}  // namespace surfmesh
