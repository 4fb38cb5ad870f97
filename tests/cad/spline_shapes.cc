// SPDX-License-Identifier: BSD-3-Clause
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepOffset_MakeSimpleOffset.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_GTrsf.hxx>
#include <numbers>

#include <TopoDS_Shape.hxx>

#include "cad/own_shapes.hh"
#include "cad/shape_parts.hh"

namespace surfmesh::testing {
namespace {

constexpr double kPrecision = 1e-6;

TopoDS_Shape nurbs(const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape).Shape(); }

/// A vase: from the axis along a spline and back to it.
TopoDS_Shape revolved_spline() {
  BRepBuilderAPI_MakeWire wire(spline_edge({{0, 0, 0}, {3, 0, 1}, {2, 0, 4}, {3, 0, 6}}));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(3, 0, 6), gp_Pnt(0, 0, 6)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 6), gp_Pnt(0, 0, 0)).Edge());
  return BRepPrimAPI_MakeRevol(face_in(wire.Wire()), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1))).Shape();
}

TopoDS_Shape periodic_prism() {
  const auto edge = spline_edge({{4, 0, 0}, {1, 2, 0}, {-3, 3, 0}, {-2, -3, 0}, {2, -2, 0}}, true);
  return drawn(face_in(wire_of(edge)), 0, 0, 5);
}

/// A spline of degree 2 with a corner inside, at a knot of multiplicity 2.
Handle(Geom_BSplineCurve) cornered_curve() {
  TColgp_Array1OfPnt poles(1, 5);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(2, 2, 0);
  poles(3) = gp_Pnt(4, 0, 0);
  poles(4) = gp_Pnt(6, 2, 0);
  poles(5) = gp_Pnt(8, 0, 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger counts(1, 3);
  for (int i = 1; i <= 3; ++i) knots(i) = i, counts(i) = i == 2 ? 2 : 3;
  return new Geom_BSplineCurve(poles, knots, counts, 2);
}

TopoDS_Shape cornered_prism() {
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(cornered_curve()).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(8, 0, 0), gp_Pnt(8, -3, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(8, -3, 0), gp_Pnt(0, -3, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, -3, 0), gp_Pnt(0, 0, 0)).Edge());
  return drawn(face_in(wire.Wire()), 0, 0, 4);
}

Handle(Geom_BSplineSurface) hilly_surface() {
  constexpr int kPoints = 6;
  TColgp_Array2OfPnt points(1, kPoints, 1, kPoints);
  for (int i = 1; i <= kPoints; ++i) {
    for (int j = 1; j <= kPoints; ++j) points(i, j) = gp_Pnt(i, j, 0.4 * std::sin(i) * std::cos(j));
  }
  return GeomAPI_PointsToBSplineSurface(points).Surface();
}

TopoDS_Shape hill() { return BRepBuilderAPI_MakeFace(hilly_surface(), kPrecision).Shape(); }

TopoDS_Shape offset_hill() {
  const Handle(Geom_OffsetSurface) offset = new Geom_OffsetSurface(hilly_surface(), 0.2);
  return BRepBuilderAPI_MakeFace(offset, kPrecision).Shape();
}

/// A block below a hilly surface.
TopoDS_Shape hilly_block() { return drawn(hill(), 0, 0, -4); }

TopoDS_Shape ellipsoid() {
  gp_GTrsf stretch;
  stretch.SetValue(1, 1, 2);
  stretch.SetValue(2, 2, 1.5);
  return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(3).Shape(), stretch).Shape();
}

TopoDS_Shape elliptic_cylinder() {
  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(gp_Ax2(), 4, 2);
  return drawn(face_in(wire_of(BRepBuilderAPI_MakeEdge(ellipse).Edge())), 1, 0, 6);
}

}  // namespace

void add_spline_shapes(std::vector<OwnShape>& shapes) {
  shapes.insert(
      shapes.end(),
      {{"revolved_spline", ".step", revolved_spline},
       {"periodic_prism", ".step", periodic_prism},
       {"cornered_prism", ".step", cornered_prism},
       {"hill", ".step", hill, ShapeKind::Sheet},
       {"offset_hill", ".brep", offset_hill, ShapeKind::Sheet},
       {"hilly_block", ".step", hilly_block},
       {"ellipsoid", ".step", ellipsoid},
       {"elliptic_cylinder", ".step", elliptic_cylinder},
       {"nurbs_sphere", ".step", [] { return nurbs(BRepPrimAPI_MakeSphere(5).Shape()); }},
       {"nurbs_torus", ".step", [] { return nurbs(BRepPrimAPI_MakeTorus(5, 2).Shape()); }},
       {"nurbs_cylinder", ".brep", [] { return nurbs(cylinder(3, 8)); }}});
}

}  // namespace surfmesh::testing
