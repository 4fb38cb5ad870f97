// SPDX-License-Identifier: BSD-3-Clause
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include <TopoDS_Shape.hxx>

#include "cad/own_shapes.hh"
#include "cad/shape_parts.hh"

namespace surfmesh::testing {
namespace {

/// A shape with its first `count` edges rounded.
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, int count) {
  BRepFilletAPI_MakeFillet maker(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= count && i <= edges.Extent(); ++i) maker.Add(radius, TopoDS::Edge(edges(i)));
  return maker.Shape();
}

TopoDS_Shape unevenly_rounded() {
  const TopoDS_Shape shape = box(10, 10, 10);
  BRepFilletAPI_MakeFillet maker(shape);
  maker.Add(1, 3, TopoDS::Edge(TopExp_Explorer(shape, TopAbs_EDGE).Current()));
  return maker.Shape();
}

TopoDS_Shape chamfered() {
  const TopoDS_Shape shape = box(10, 10, 10);
  BRepFilletAPI_MakeChamfer maker(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) maker.Add(1, TopoDS::Edge(edges(i)));
  return maker.Shape();
}

TopoDS_Wire square(double half, double z) {
  return polygon({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

TopoDS_Shape loft(const std::vector<TopoDS_Wire>& sections, bool is_ruled) {
  BRepOffsetAPI_ThruSections maker(true, is_ruled);
  for (const TopoDS_Wire& section : sections) maker.AddWire(section);
  return maker.Shape();
}

/// A disc of a radius around a point, facing a direction.
TopoDS_Wire ring(const gp_Pnt& centre, const gp_Dir& direction, double radius) {
  return wire_of(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, direction), radius)).Edge());
}

TopoDS_Shape pipe() {
  const TopoDS_Wire spine = wire_of(spline_edge({{0, 0, 0}, {0, 2, 8}, {5, 4, 12}, {12, 3, 12}}));
  return BRepOffsetAPI_MakePipe(spine, face_in(ring({0, 0, 0}, {0, 0, 1}, 1))).Shape();
}

TopoDS_Shape spring() {
  BRepOffsetAPI_MakePipeShell maker(helix(5, 3, 3));
  maker.SetMode(true);
  maker.Add(ring({5, 0, 0}, {0, 1, 0}, 0.6));
  maker.Build();
  maker.MakeSolid();
  return maker.Shape();
}

/// A rod with a ridge of a triangular section along a helix.
TopoDS_Shape thread() {
  BRepOffsetAPI_MakePipeShell maker(helix(3, 2, 3));
  maker.SetMode(gp_Dir(0, 0, 1));
  maker.Add(polygon({{2.9, 0, -0.6}, {3.7, 0, 0}, {2.9, 0, 0.6}}));
  maker.Build();
  maker.MakeSolid();
  return fused(moved(cylinder(3, 12), 0, 0, -3), maker.Shape());
}

TopoDS_Shape open_box() {
  const TopoDS_Shape shape = box(10, 10, 10);
  TopTools_ListOfShape open;
  open.Append(face_towards(shape, {0, 0, 1}));
  BRepOffsetAPI_MakeThickSolid maker;
  constexpr double kTolerance = 1e-5;
  maker.MakeThickSolidByJoin(shape, open, -1, kTolerance);
  return maker.Shape();
}

TopoDS_Shape drafted() {
  const TopoDS_Shape shape = box(10, 10, 10);
  BRepOffsetAPI_DraftAngle maker(shape);
  const gp_Pln ground(gp_Pnt(), gp_Dir(0, 0, 1));
  for (const gp_Dir& side : {gp_Dir(1, 0, 0), gp_Dir(-1, 0, 0), gp_Dir(0, 1, 0)}) {
    maker.Add(face_towards(shape, side), gp_Dir(0, 0, 1), 0.1, ground);
  }
  maker.Build();
  return maker.Shape();
}

/// A box with everything around it to a distance: its edges and corners are rounded.
TopoDS_Shape offset_box() {
  BRepOffsetAPI_MakeOffsetShape maker;
  constexpr double kTolerance = 1e-5;
  maker.PerformByJoin(box(6, 5, 4), 1, kTolerance);
  return maker.Shape();
}

}  // namespace

void add_swept_shapes(std::vector<OwnShape>& shapes) {
  shapes.insert(shapes.end(),
                {{"fillet", ".step", [] { return rounded(box(10, 10, 10), 2, 1); }},
                 {"fillets", ".step", [] { return rounded(box(10, 10, 10), 2, 12); }},
                 {"fillet_uneven", ".step", unevenly_rounded},
                 {"fillet_cylinder", ".step", [] { return rounded(cylinder(4, 6), 1, 1); }},
                 {"chamfers", ".step", chamfered},
                 {"loft_ruled", ".step",
                  [] {
                    return loft({square(2, 0), square(1, 5)}, true);
                  }},
                 {"loft_round", ".step",
                  [] {
                    return loft({circle(3, 0), circle(1.5, 3), circle(3, 6)}, false);
                  }},
                 {"loft_square_to_round", ".step",
                  [] {
                    return loft({square(2, 0), circle(1, 5)}, false);
                  }},
                 {"pipe", ".step", pipe},
                 {"spring", ".step", spring},
                 {"thread", ".step", thread},
                 {"open_box", ".step", open_box},
                 {"draft", ".step", drafted},
                 {"offset_box", ".step", offset_box}});
}

}  // namespace surfmesh::testing
