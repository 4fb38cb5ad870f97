// SPDX-License-Identifier: BSD-3-Clause
#include "cad/shape_parts.hh"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <numbers>
#include <stdexcept>

namespace surfmesh::testing {

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }

TopoDS_Shape cylinder(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, y, z));
  return BRepBuilderAPI_Transform(shape, move, true).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(), axis), angle);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Fuse(a, b).Shape();
}

TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Common(a, b).Shape();
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

TopLoc_Location translation(double x, double y, double z) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(x, y, z));
  return TopLoc_Location(move);
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon maker;
  for (const gp_Pnt& corner : corners) maker.Add(corner);
  maker.Close();
  return maker.Wire();
}

TopoDS_Wire circle(double radius, double z) {
  return wire_of(
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), radius)).Edge());
}

TopoDS_Edge spline_edge(const std::vector<gp_Pnt>& points, bool is_periodic) {
  const Handle(TColgp_HArray1OfPnt) array =
      new TColgp_HArray1OfPnt(1, static_cast<Standard_Integer>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    array->SetValue(static_cast<Standard_Integer>(i) + 1, points[i]);
  }
  constexpr double kNearest = 1e-9;
  GeomAPI_Interpolate maker(array, is_periodic, kNearest);
  maker.Perform();
  return BRepBuilderAPI_MakeEdge(maker.Curve()).Edge();
}

TopoDS_Wire wire_of(const TopoDS_Edge& edge) { return BRepBuilderAPI_MakeWire(edge).Wire(); }

TopoDS_Face face_in(const TopoDS_Wire& wire) { return BRepBuilderAPI_MakeFace(wire).Face(); }

TopoDS_Shape drawn(const TopoDS_Shape& base, double x, double y, double z) {
  return BRepPrimAPI_MakePrism(base, gp_Vec(x, y, z)).Shape();
}

TopoDS_Face face_towards(const TopoDS_Shape& shape, const gp_Dir& direction) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() != GeomAbs_Plane) continue;
    gp_Pnt point;
    gp_Vec du, dv;
    surface.D1(0, 0, point, du, dv);
    gp_Vec normal = du.Crossed(dv);
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    constexpr double kParallel = 0.999;
    if (normal.Normalized().Dot(gp_Vec(direction)) > kParallel) return face;
  }
  throw std::invalid_argument("no face has that normal");
}

TopoDS_Wire helix(double radius, double pitch, double turns) {
  const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(gp_Ax3(), radius);
  const double turn = 2 * std::numbers::pi;
  const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(turn, pitch));
  const double length = turns * std::hypot(turn, pitch);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, surface, 0, length).Edge();
  BRepLib::BuildCurves3d(edge);
  return wire_of(edge);
}

}  // namespace surfmesh::testing
