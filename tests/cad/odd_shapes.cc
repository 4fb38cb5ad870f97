// SPDX-License-Identifier: BSD-3-Clause
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
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
       {"loose_box", ".iges", [] { return box(3, 4, 5); }},
       {"loose_cylinder", ".iges", [] { return cylinder(3, 4); }},
       {"loose_hole", ".igs",
        [] { return without(box(10, 10, 4), moved(cylinder(2, 4), 5, 5, 0)); }}});
}

}  // namespace surfmesh::testing
