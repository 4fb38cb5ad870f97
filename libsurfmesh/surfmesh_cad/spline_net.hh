// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "surfmesh/geometry/domain.hh"
#include "surfmesh/nurbs/nurbs_net.hh"

namespace surfmesh {

/// The definition of a B-spline surface of a file, clamped. A periodic one is repeated until it
/// covers the domain, which may lie anywhere and cross the ends of periods.
NurbsNet spline_net(const Handle(Geom_BSplineSurface) & surface, const Domain& domain);

/// The same of a B-spline curve in parameters, for a part of it.
NurbsPolygon spline_polygon(const Handle(Geom2d_BSplineCurve) & curve, double from, double to);

}  // namespace surfmesh
