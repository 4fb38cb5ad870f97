// SPDX-License-Identifier: BSD-3-Clause
#include <BOPAlgo_Builder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <numbers>

#include <TopoDS_Shape.hxx>

#include "cad/own_shapes.hh"
#include "cad/shape_parts.hh"

namespace surfmesh::testing {
namespace {

const double kQuarter = std::numbers::pi / 2;

TopoDS_Shape sphere(double radius) { return BRepPrimAPI_MakeSphere(radius).Shape(); }

TopoDS_Shape perforated() {
  std::vector<TopoDS_Shape> drills;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) drills.push_back(moved(cylinder(0.3, 1), 1 + i, 1 + j, 0));
  }
  return without(box(7, 6, 1), together(drills));
}

TopoDS_Shape cross_drilled() {
  const TopoDS_Shape bore = turned(moved(cylinder(1, 10), 0, 0, -5), {1, 0, 0}, kQuarter);
  return without(cylinder(3, 8), moved(bore, 0, 0, 4));
}

TopoDS_Shape crossed_pipes() {
  const TopoDS_Shape branch = turned(moved(cylinder(1, 10), 0, 0, -5), {0, 1, 0}, kQuarter);
  return fused(moved(cylinder(1, 10), 0, 0, -5), branch);
}

/// A hole that touches an edge of the box from inside.
TopoDS_Shape tangent_hole() { return without(box(10, 10, 3), moved(cylinder(2, 3), 2, 5, 0)); }

/// A cross bore whose rim ends where the seam of the cylinder does: on its top.
TopoDS_Shape seam_on_hole() {
  const TopoDS_Shape bore = turned(cylinder(1, 10), {0, 1, 0}, kQuarter);
  return without(cylinder(3, 6), moved(bore, 0, 0, 5));
}

/// Two boxes that share a face.
TopoDS_Shape glued() {
  BOPAlgo_Builder builder;
  builder.AddArgument(box(1, 1, 1));
  builder.AddArgument(moved(box(1, 1, 1), 1, 0, 0));
  builder.Perform();
  return builder.Shape();
}

/// Three boxes around one edge.
TopoDS_Shape glued_around_edge() {
  BOPAlgo_Builder builder;
  builder.AddArgument(box(1, 1, 1));
  builder.AddArgument(moved(box(1, 1, 1), 1, 0, 0));
  builder.AddArgument(moved(box(1, 1, 1), 0, 1, 0));
  builder.Perform();
  return builder.Shape();
}

TopoDS_Shape slotted_shaft() {
  const TopoDS_Shape slot = moved(box(10, 1, 4), 0, -0.5, 2);
  return without(fused(cylinder(2, 10), cylinder(3, 2)), moved(slot, 1, 0, 0));
}

}  // namespace

void add_cut_shapes(std::vector<OwnShape>& shapes) {
  shapes.insert(
      shapes.end(),
      {{"fuse", ".step", [] { return fused(box(10, 10, 4), moved(cylinder(3, 8), 5, 5, 0)); }},
       {"hole", ".step", [] { return without(box(10, 10, 4), moved(cylinder(2, 4), 5, 5, 0)); }},
       {"blind_hole", ".step",
        [] { return without(box(10, 10, 4), moved(cylinder(2, 4), 5, 5, 2)); }},
       {"common", ".step", [] { return common(moved(box(8, 8, 8), -4, -4, -4), sphere(5)); }},
       {"perforated", ".step", perforated},
       {"cross_drilled", ".step", cross_drilled},
       {"crossed_pipes", ".step", crossed_pipes},
       {"tangent_hole", ".step", tangent_hole},
       {"seam_on_hole", ".step", seam_on_hole},
       {"slotted_shaft", ".step", slotted_shaft},
       {"hollow_box", ".step", [] { return without(box(4, 4, 4), moved(box(2, 2, 2), 1, 1, 1)); }},
       {"hollow_sphere", ".step", [] { return without(sphere(5), sphere(3)); }},
       {"glued", ".brep", glued, ShapeKind::Glued},
       {"glued_around_edge", ".brep", glued_around_edge, ShapeKind::Glued},
       {"touching", ".step", [] {
          return together({box(1, 1, 1), moved(box(1, 1, 1), 1, 0, 0)});
        }}});
}

}  // namespace surfmesh::testing
