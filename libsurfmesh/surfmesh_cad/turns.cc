// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/turns.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

void check_turns_along(double start, double end, double from, double to) {
  const double turns = std::max(std::abs(from - start), std::abs(to - start)) / (end - start);
  if (turns <= kMostTurns) return;
  throw Error(ErrorCode::Geometry,
              fmt::format("it is {:.3g} turns away from the start of its surface", turns));
}

}  // namespace

void check_turns(const Geom_Surface& surface, const Domain& domain) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  if (surface.IsUPeriodic()) check_turns_along(u0, u1, domain.u0, domain.u1);
  if (surface.IsVPeriodic()) check_turns_along(v0, v1, domain.v0, domain.v1);
}

}  // namespace surfmesh
