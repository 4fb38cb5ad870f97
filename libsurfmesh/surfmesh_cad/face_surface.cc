// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/face_surface.hh"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <cmath>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/offset_surface.hh"
#include "surfmesh_cad/spline_surface.hh"
#include "surfmesh_cad/stateless_surface.hh"
#include "surfmesh_cad/turns.hh"

namespace surfmesh {
namespace {

/// Cells narrower than this share of the domain are none: a border of the domain on a knot.
constexpr double kLeastCell = 1e-9;

/// The lines between cells from `from` to `to`: the knots between them, again in each period.
std::vector<double> cell_lines(const std::vector<double>& knots, double period, double from,
                               double to) {
  std::vector<double> lines = {from};
  const double least = kLeastCell * (to - from);
  const int periods = period > 0 ? static_cast<int>(std::ceil((to - from) / period)) + 1 : 0;
  const double first =
      period > 0 && !knots.empty() ? std::floor((from - knots.front()) / period) : 0;
  for (int i = 0; i <= periods; ++i) {
    for (const double knot : knots) {
      const double line = knot + (first + i) * period;
      if (line > lines.back() + least && line < to - least) lines.push_back(line);
    }
  }
  lines.push_back(to);
  return lines;
}

std::vector<double> knots_of(Handle(Geom_Curve) curve) {
  std::vector<double> knots;
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return knots;
  for (Standard_Integer k = 1; k <= spline->NbKnots(); ++k) knots.push_back(spline->Knot(k));
  return knots;
}

/// The knots of a surface along u and v, as far as it has such.
struct Knots {
  std::vector<double> u;
  std::vector<double> v;
};

Knots knots_of(const Handle(Geom_Surface) & surface) {
  Knots knots;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface)) {
    for (Standard_Integer k = 1; k <= spline->NbUKnots(); ++k) knots.u.push_back(spline->UKnot(k));
    for (Standard_Integer k = 1; k <= spline->NbVKnots(); ++k) knots.v.push_back(spline->VKnot(k));
  } else if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface)) {
    knots.v = knots_of(turned->BasisCurve());
  } else if (const auto drawn = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface)) {
    knots.u = knots_of(drawn->BasisCurve());
  } else if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface)) {
    return knots_of(offset->BasisSurface());
  }
  return knots;
}

UnevenCells cells_of(const Handle(Geom_Surface) & surface, const Domain& domain) {
  const Knots knots = knots_of(surface);
  const double period_u = surface->IsUPeriodic() ? surface->UPeriod() : 0;
  const double period_v = surface->IsVPeriodic() ? surface->VPeriod() : 0;
  return {cell_lines(knots.u, period_u, domain.u0, domain.u1),
          cell_lines(knots.v, period_v, domain.v0, domain.v1)};
}

/// The same surface in a simpler form, if there is one: not trimmed, not at a distance from a plane
/// or a cylinder, and no Bézier patch.
Handle(Geom_Surface) simplest(Handle(Geom_Surface) surface) {
  for (;;) {
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
      surface = trimmed->BasisSurface();
      continue;
    }
    const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
    if (offset.IsNull() || offset->Surface().IsNull()) break;
    surface = offset->Surface();
  }
  if (!Handle(Geom_BezierSurface)::DownCast(surface).IsNull()) {
    return GeomConvert::SurfaceToBSplineSurface(surface);
  }
  return surface;
}

}  // namespace

Handle(Geom_Surface) surface_of(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) throw Error(ErrorCode::Geometry, "it has no surface");
  return simplest(surface);
}

std::shared_ptr<const Surface> face_surface(const Handle(Geom_Surface) & surface,
                                            const Domain& domain) {
  check_turns(*surface, domain);
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface)) {
    return spline_surface(spline, domain);
  }
  UnevenCells cells = cells_of(surface, domain);
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface)) {
    return offset_surface(offset, domain, std::move(cells));
  }
  return stateless_surface(surface, domain, std::move(cells));
}

}  // namespace surfmesh
