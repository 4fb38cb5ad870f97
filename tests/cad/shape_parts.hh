// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BRepBuilderAPI_Transform.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <vector>

namespace surfmesh::testing {

/// What shapes of tests are made of. Boxes have a corner at the origin, all else its axis along z.
TopoDS_Shape box(double x, double y, double z);
TopoDS_Shape cylinder(double radius, double height);
TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z);
TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle);
TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b);
TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b);
TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b);
TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes);
TopLoc_Location translation(double x, double y, double z);

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners);
TopoDS_Wire circle(double radius, double z);
TopoDS_Edge spline_edge(const std::vector<gp_Pnt>& points, bool is_periodic = false);
TopoDS_Wire wire_of(const TopoDS_Edge& edge);
TopoDS_Face face_in(const TopoDS_Wire& wire);
TopoDS_Shape drawn(const TopoDS_Shape& base, double x, double y, double z);

/// The plane face whose normal is a direction.
TopoDS_Face face_towards(const TopoDS_Shape& shape, const gp_Dir& direction);

/// A helix around z: radius, pitch, turns.
TopoDS_Wire helix(double radius, double pitch, double turns);

}  // namespace surfmesh::testing
