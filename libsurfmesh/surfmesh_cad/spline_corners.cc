// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/spline_corners.hh"

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "surfmesh/nurbs/split_at_creases.hh"
#include "surfmesh_cad/spline_net.hh"

namespace surfmesh {
namespace {

/// 0.1°, as where NURBS surfaces of our own are divided.
constexpr double kCornerAngle = 0.0017;

bool has_corner(Handle(Geom_Curve) curve) {
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull() || spline->IsCN(1)) return false;
  for (Standard_Integer k = 2; k < spline->NbKnots(); ++k) {
    if (spline->Multiplicity(k) < spline->Degree()) continue;
    gp_Pnt point;
    gp_Vec before, behind;
    spline->LocalD1(spline->Knot(k), k - 1, k, point, before);
    spline->LocalD1(spline->Knot(k), k, k + 1, point, behind);
    const bool has_directions = before.Magnitude() > 0 && behind.Magnitude() > 0;
    if (has_directions && before.Angle(behind) > kCornerAngle) return true;
  }
  return false;
}

bool has_corner(Handle(Geom_Surface) surface) {
  if (surface.IsNull()) return false;
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
    return has_corner(trimmed->BasisSurface());
  }
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface)) {
    return has_corner(offset->BasisSurface());
  }
  if (const auto swept = Handle(Geom_SweptSurface)::DownCast(surface)) {
    return has_corner(swept->BasisCurve());
  }
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull() || (spline->IsCNu(1) && spline->IsCNv(1))) return false;
  Domain domain;
  spline->Bounds(domain.u0, domain.u1, domain.v0, domain.v1);
  return split_at_creases(spline_net(spline, domain), domain).size() > 1;
}

bool has_corner(const TopoDS_Edge& edge) {
  Standard_Real first, last;
  return has_corner(BRep_Tool::Curve(edge, first, last));
}

}  // namespace

bool has_corners(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, TopAbs_FACE, parts);
  const Standard_Integer faces = parts.Extent();
  TopExp::MapShapes(shape, TopAbs_EDGE, parts);
  TopLoc_Location ignored;
  for (Standard_Integer i = 1; i <= parts.Extent(); ++i) {
    const bool is_face = i <= faces;
    if (is_face ? has_corner(BRep_Tool::Surface(TopoDS::Face(parts(i)), ignored))
                : has_corner(TopoDS::Edge(parts(i)))) {
      return true;
    }
  }
  return false;
}

}  // namespace surfmesh
