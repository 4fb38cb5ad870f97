// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/surface_checks.hh"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// The coordinates that are not finite in a vector: "x, z".
std::string coordinates(const Vec3& vector) {
  std::string names;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(vector[i]))
      names += fmt::format("{}{}", names.empty() ? "" : ", ", "xyz"[i]);
  }
  return names;
}

/// What of the lowest order is not finite: "second derivatives of x, z".
std::string worst_part(const Jet& jet, Order order) {
  const std::string position = coordinates(jet.point);
  if (!position.empty() || order == Order::Position) return position;
  const std::string first = coordinates(jet.du.cwiseAbs() + jet.dv.cwiseAbs());
  if (!first.empty() || order == Order::First) return "first derivatives of " + first;
  return "second derivatives of " +
         coordinates(jet.duu.cwiseAbs() + jet.duv.cwiseAbs() + jet.dvv.cwiseAbs());
}

}  // namespace

void check(const Domain& domain) {
  const bool is_finite = std::isfinite(domain.u0) && std::isfinite(domain.u1) &&
                         std::isfinite(domain.v0) && std::isfinite(domain.v1);
  if (is_finite && domain.u0 < domain.u1 && domain.v0 < domain.v1) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the domain u in [{}, {}], v in [{}, {}] is empty or not finite",
                          domain.u0, domain.u1, domain.v0, domain.v1));
}

void throw_not_finite(const Jet& jet, Uv uv, Order order) {
  const char* what = order == Order::Position ? "position" : "position or a derivative";
  throw Error(ErrorCode::Geometry,
              fmt::format("the {} of the surface at (u,v) = ({}, {}) is not finite: {}; {}", what,
                          uv.u, uv.v, worst_part(jet, order),
                          jet.point.allFinite()
                              ? "let the domain begin beside it, or write the surface so that it "
                                "has a tangent plane there"
                              : "let the domain keep away from it, or give the surface a value "
                                "there, in formulas by if(...)"));
}

}  // namespace surfmesh
