// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/surface_checks.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {

void check(const Domain& domain) {
  const bool is_finite = std::isfinite(domain.u0) && std::isfinite(domain.u1) &&
                         std::isfinite(domain.v0) && std::isfinite(domain.v1);
  if (is_finite && domain.u0 < domain.u1 && domain.v0 < domain.v1) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the domain u in [{}, {}], v in [{}, {}] is empty or not finite",
                          domain.u0, domain.u1, domain.v0, domain.v1));
}

void throw_not_finite(Uv uv, Order order) {
  const char* what = order == Order::Position ? "position" : "position or a derivative";
  throw Error(
      ErrorCode::Geometry,
      fmt::format("the {} of the surface at (u,v) = ({}, {}) is not finite", what, uv.u, uv.v));
}

}  // namespace surfmesh
