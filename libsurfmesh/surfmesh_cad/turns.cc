// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/turns.hh"

#include <algorithm>
#include <cmath>

namespace surfmesh {
namespace {

double turns_along(double start, double end, double from, double to) {
  return std::max({std::abs(from - start), std::abs(to - start), to - from}) / (end - start);
}

}  // namespace

double turns(const Geom_Surface& surface, const Domain& domain) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  const double along_u = surface.IsUPeriodic() ? turns_along(u0, u1, domain.u0, domain.u1) : 0;
  const double along_v = surface.IsVPeriodic() ? turns_along(v0, v1, domain.v0, domain.v1) : 0;
  return std::max(along_u, along_v);
}

}  // namespace surfmesh
