// SPDX-License-Identifier: BSD-3-Clause
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <numbers>

#include <TopoDS_Shape.hxx>

#include "cad/own_shapes.hh"
#include "cad/shape_parts.hh"

namespace surfmesh::testing {
namespace {

TopoDS_Shape revolved() {
  const auto profile = polygon({{2, 0, 0}, {5, 0, 0}, {5, 0, 1}, {3, 0, 2}, {2, 0, 4}});
  return BRepPrimAPI_MakeRevol(face_in(profile), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1))).Shape();
}

TopoDS_Shape hexagon() {
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    corners.emplace_back(2 * std::cos(angle), 2 * std::sin(angle), 0);
  }
  return drawn(face_in(polygon(corners)), 0, 0, 5);
}

}  // namespace

void add_simple_shapes(std::vector<OwnShape>& shapes) {
  const double pi = std::numbers::pi;
  shapes.insert(
      shapes.end(),
      {{"box", ".step", [] { return box(10, 20, 30); }},
       {"box_brep", ".brep", [] { return box(10, 20, 30); }},
       {"cylinder", ".step", [] { return cylinder(3, 8); }},
       {"cylinder_part", ".step", [=] { return BRepPrimAPI_MakeCylinder(3, 8, pi / 3).Shape(); }},
       {"cone", ".step", [] { return BRepPrimAPI_MakeCone(3, 0, 8).Shape(); }},
       {"cone_frustum", ".step", [] { return BRepPrimAPI_MakeCone(3, 1, 8).Shape(); }},
       {"sphere", ".step", [] { return BRepPrimAPI_MakeSphere(5).Shape(); }},
       {"sphere_part", ".step",
        [=] { return BRepPrimAPI_MakeSphere(5, -pi / 6, pi / 4, 1.5 * pi).Shape(); }},
       {"torus", ".step", [] { return BRepPrimAPI_MakeTorus(5, 2).Shape(); }},
       {"torus_part", ".brep", [=] { return BRepPrimAPI_MakeTorus(5, 2, pi / 2).Shape(); }},
       {"wedge", ".step", [] { return BRepPrimAPI_MakeWedge(4, 5, 6, 1).Shape(); }},
       {"hexagon", ".step", hexagon},
       {"revolved", ".step", revolved}});
}

}  // namespace surfmesh::testing
