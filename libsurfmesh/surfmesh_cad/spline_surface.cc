// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/spline_surface.hh"

#include <TColStd_Array1OfReal.hxx>
#include <cmath>

#include "surfmesh/nurbs/nurbs_surface.hh"
#include "surfmesh_cad/spline_net.hh"

namespace surfmesh {
namespace {

/// An end of the domain nearer to a knot than this share of it is the knot: no cell is narrower.
constexpr double kKnotShare = 1e-9;

/// A value, or the knot that it lies at. Without a period, the period is 0.
double at_knot(double value, const TColStd_Array1OfReal& knots, double period, double reach) {
  for (const double knot : knots) {
    const double turns = period > 0 ? std::round((value - knot) / period) : 0;
    if (std::abs(value - knot - turns * period) <= reach) return knot + turns * period;
  }
  return value;
}

Domain at_knots(const Geom_BSplineSurface& surface, Domain domain) {
  const double period_u = surface.IsUPeriodic() ? surface.UPeriod() : 0;
  const double period_v = surface.IsVPeriodic() ? surface.VPeriod() : 0;
  const double reach_u = kKnotShare * (domain.u1 - domain.u0);
  const double reach_v = kKnotShare * (domain.v1 - domain.v0);
  domain.u0 = at_knot(domain.u0, surface.UKnots(), period_u, reach_u);
  domain.u1 = at_knot(domain.u1, surface.UKnots(), period_u, reach_u);
  domain.v0 = at_knot(domain.v0, surface.VKnots(), period_v, reach_v);
  domain.v1 = at_knot(domain.v1, surface.VKnots(), period_v, reach_v);
  return domain;
}

}  // namespace

std::shared_ptr<const Surface> spline_surface(const Handle(Geom_BSplineSurface) & surface,
                                              const Domain& domain) {
  const Domain whole = at_knots(*surface, domain);
  return std::make_shared<NurbsSurface>(spline_net(surface, whole), whole);
}

}  // namespace surfmesh
