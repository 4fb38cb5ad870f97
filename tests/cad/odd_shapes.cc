// SPDX-License-Identifier: BSD-3-Clause
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pln.hxx>

#include <TopoDS_Shape.hxx>

#include "cad/own_shapes.hh"
#include "cad/shape_parts.hh"

namespace surfmesh::testing {
namespace {

TopoDS_Shape sheet(const TopoDS_Shape& shape, const TopoDS_Shape& without_face) {
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    if (!it.Current().IsSame(without_face)) builder.Add(shell, it.Current());
  }
  return shell;
}

TopoDS_Shape open_sheet() {
  const TopoDS_Shape shape = box(4, 5, 6);
  return sheet(shape, face_towards(shape, {0, 0, 1}));
}

/// A plane face with a hole.
TopoDS_Shape trimmed_face() {
  const TopoDS_Wire outer = polygon({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}});
  BRepBuilderAPI_MakeFace maker(gp_Pln(), outer);
  maker.Add(TopoDS::Wire(circle(2, 0).Reversed()));
  return maker.Shape();
}

TopoDS_Shape mirrored() {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)));
  const TopoDS_Shape part = fused(box(4, 2, 2), moved(cylinder(1, 5), 3, 1, 0));
  return BRepBuilderAPI_Transform(part, mirror, false).Shape();
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor) {
  gp_Trsf scale;
  scale.SetScale(gp_Pnt(), factor);
  return BRepBuilderAPI_Transform(shape, scale, true).Shape();
}

/// The same part in two places.
TopoDS_Shape placed_twice() {
  const TopoDS_Shape part = BRepPrimAPI_MakeCone(2, 1, 3).Shape();
  return together({part, part.Moved(translation(10, 0, 0))});
}

/// A block with an edge of a millionth, far below what counts, as careless sketches leave.
TopoDS_Shape micro_edge() {
  constexpr double kMicro = 1e-6;
  const auto outline =
      polygon({{0, 0, 0}, {5, 0, 0}, {5 + kMicro, 0, 0}, {20, 0, 0}, {20, 9, 0}, {0, 9, 0}});
  return drawn(face_in(outline), 0, 0, 3);
}

/// A sphere whose wire lacks the sides at the poles.
TopoDS_Shape sphere_without_poles() {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(3).Shape();
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(sphere, TopAbs_FACE).Current());
  TopoDS_Wire wire;
  TopoDS_Face bare;
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeWire(wire);
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) builder.Add(wire, it.Current());
  }
  constexpr double kTolerance = 1e-7;
  builder.MakeFace(bare, BRep_Tool::Surface(face), kTolerance);
  builder.Add(bare, wire);
  builder.MakeShell(shell);
  builder.Add(shell, bare);
  shell.Closed(true);
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// A tube whose face lacks the seam: it has two loops, neither of which closes in its parameters.
TopoDS_Shape tube_without_seam() {
  constexpr double kTolerance = 1e-7;
  const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(gp_Ax3(), 2);
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface, kTolerance);
  for (const double z : {0.0, 5.0}) {
    const TopoDS_Wire wire = circle(2, z);
    const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(wire, TopAbs_EDGE).Current());
    const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, z), gp_Dir2d(1, 0));
    builder.UpdateEdge(edge, line, face, kTolerance);
    builder.Add(face, wire.Oriented(z == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  return face;
}

/// A box with an edge on a face that bounds nothing.
TopoDS_Shape inner_edge() {
  const TopoDS_Shape shape = box(4, 4, 4);
  TopoDS_Face top = face_towards(shape, {0, 0, 1});
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 4), gp_Pnt(3, 2, 4)).Edge();
  top.Free(true);
  BRep_Builder().Add(top, wire_of(edge).Oriented(TopAbs_INTERNAL));
  return shape;
}

}  // namespace

void add_odd_shapes(std::vector<OwnShape>& shapes) {
  constexpr double kTiny = 1e-3, kLarge = 1e6;
  shapes.insert(
      shapes.end(),
      {{"open_sheet", ".step", open_sheet, ShapeKind::Sheet},
       {"trimmed_face", ".step", trimmed_face, ShapeKind::Sheet},
       {"mirrored", ".brep", mirrored},
       {"placed_twice", ".brep", placed_twice},
       {"tiny", ".step", [] { return scaled(fused(box(1, 1, 1), cylinder(0.5, 2)), kTiny); }},
       {"large", ".step", [] { return scaled(fused(box(1, 1, 1), cylinder(0.5, 2)), kLarge); }},
       {"inches", ".step", [] { return box(25.4, 25.4, 25.4); }, ShapeKind::Solid, "INCH"},
       {"micro_edge", ".brep", micro_edge},
       {"sphere_without_poles", ".brep", sphere_without_poles},
       {"inner_edge", ".brep", inner_edge},
       {"tube_without_seam", ".brep", tube_without_seam, ShapeKind::Sheet},
       {"loose_box", ".iges", [] { return box(3, 4, 5); }},
       {"loose_cylinder", ".iges", [] { return cylinder(3, 4); }},
       {"loose_hollow", ".iges",
        [] { return without(box(4, 4, 4), moved(box(2, 2, 2), 1, 1, 1)); }},
       {"loose_hole", ".igs",
        [] { return without(box(10, 10, 4), moved(cylinder(2, 4), 5, 5, 0)); }}});
}

}  // namespace surfmesh::testing
