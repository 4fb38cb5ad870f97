// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/face_loops.hh"

#include <fmt/format.h>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <ShapeExtend_WireData.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/face_surface.hh"
#include "surfmesh_cad/file_points.hh"
#include "surfmesh_cad/loop_box.hh"

namespace surfmesh {
namespace {

/// Ends that are to meet may be so far apart, as a share of the box of the loop in parameters.
/// Beyond it a side is missing: at a pole, where it has no length.
constexpr double kMostGap = 0.02;

/// Points of a side without length are nearer than this share of the extent of the loop in space.
constexpr double kPoleExtent = 1e-4;

/// Points along a side, to see whether it has a length.
constexpr int kPolePoints = 8;

/// The periods of a surface; 0 for none.
struct Periods {
  double u = 0;
  double v = 0;

  explicit Periods(const Geom_Surface& surface)
      : u(surface.IsUPeriodic() ? surface.UPeriod() : 0),
        v(surface.IsVPeriodic() ? surface.VPeriod() : 0) {}

  /// The whole periods nearest to a step.
  Uv nearest(Uv step) const {
    return {u > 0 ? u * std::round(step.u / u) : 0, v > 0 ? v * std::round(step.v / v) : 0};
  }
};

Uv begin_of(const FaceEdge& edge) {
  return edge.is_forward ? edge.curve.start() : edge.curve.end();
}
Uv end_of(const FaceEdge& edge) { return edge.is_forward ? edge.curve.end() : edge.curve.start(); }

void shift(FaceEdge& edge, Uv step) {
  edge.curve.move_first = edge.curve.move_first + step;
  edge.curve.move_last = edge.curve.move_last + step;
}

/// Move the end of an edge where the loop comes to it, or leaves it.
void move_end(FaceEdge& edge, bool is_at_end, Uv step) {
  Uv& move = is_at_end == edge.is_forward ? edge.curve.move_last : edge.curve.move_first;
  move = move + step;
}

bool bounds(TopAbs_Orientation orientation) {
  return orientation == TopAbs_FORWARD || orientation == TopAbs_REVERSED;
}

/// The edges of a wire in their order. Those that lie inside the face bound nothing.
std::vector<TopoDS_Edge> ordered_edges(const TopoDS_Wire& wire, const TopoDS_Face& face,
                                       int& dropped) {
  int count = 0;
  for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
    ++(bounds(it.Value().Orientation()) ? count : dropped);
  }
  std::vector<TopoDS_Edge> edges;
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
    if (bounds(it.Current().Orientation())) edges.push_back(it.Current());
  }
  if (static_cast<int>(edges.size()) == count) return edges;
  // The explorer stops where it finds no way on: then the order is that of the file.
  edges.clear();
  const Handle(ShapeExtend_WireData) list = new ShapeExtend_WireData(wire);
  for (Standard_Integer i = 1; i <= list->NbEdges(); ++i) edges.push_back(list->Edge(i));
  return edges;
}

FaceEdge face_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  FaceEdge result;
  result.edge = edge;
  result.is_forward = edge.Orientation() == TopAbs_FORWARD;
  result.curve.curve = BRep_Tool::CurveOnSurface(edge, face, result.curve.first, result.curve.last);
  if (result.curve.curve.IsNull()) {
    throw Error(ErrorCode::Geometry, "an edge has no curve in its parameters");
  }
  return result;
}

/// Builds the boundary of one face.
class Boundary {
 public:
  explicit Boundary(const TopoDS_Face& face)
      : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
        surface_(surface_of(face_)),
        periods_(*surface_) {}

  FaceBoundary make() {
    const TopoDS_Wire outer = BRepTools::OuterWire(face_);
    for (TopoDS_Iterator it(face_); it.More(); it.Next()) {
      if (it.Value().ShapeType() == TopAbs_WIRE) add_wire(TopoDS::Wire(it.Value()), outer);
    }
    if (result_.loops.empty()) throw Error(ErrorCode::Geometry, "it has no boundary");
    for (FaceLoop& loop : result_.loops) close(loop);
    shift_holes();
    set_domain();
    return std::move(result_);
  }

 private:
  void add_wire(const TopoDS_Wire& wire, const TopoDS_Wire& outer) {
    if (!bounds(wire.Orientation())) {
      result_.dropped_edges += wire.NbChildren();
      return;
    }
    FaceLoop loop;
    for (const TopoDS_Edge& edge : ordered_edges(wire, face_, result_.dropped_edges)) {
      loop.push_back(face_edge(edge, face_));
    }
    if (loop.empty()) return;
    const auto place = wire.IsSame(outer) ? result_.loops.begin() : result_.loops.end();
    result_.loops.insert(place, std::move(loop));
  }

  /// Bring the ends of edges that follow each other together.
  void close(FaceLoop& loop) {
    for (std::size_t i = 1; i < loop.size(); ++i) {
      shift(loop[i], periods_.nearest(end_of(loop[i - 1]) - begin_of(loop[i])));
    }
    const LoopBox box = box_of(loop);
    FaceLoop closed;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      FaceEdge& next = loop[(i + 1) % loop.size()];
      const Uv gap = begin_of(next) - end_of(loop[i]);
      const bool is_near =
          std::abs(gap.u) <= kMostGap * box.width() && std::abs(gap.v) <= kMostGap * box.height();
      if (is_near) {
        // The same sum at both, not one by the other's difference: to the last bit.
        move_end(loop[i], true, 0.5 * gap);
        move_end(next, false, -0.5 * gap);
      }
      poles_.push_back({});
      if (!is_near) poles_.back() = pole(loop[i], next, box);
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      closed.push_back(loop[i]);
      if (poles_[i]) closed.push_back(*poles_[i]);
    }
    poles_.clear();
    loop = std::move(closed);
  }

  /// The side that a file leaves out at a pole.
  FaceEdge pole(const FaceEdge& before, const FaceEdge& after, const LoopBox& box) const {
    const Uv from = end_of(before), to = begin_of(after);
    const Vec3 start = point(from);
    double extent = 0;
    for (int i = 1; i <= kPolePoints; ++i) {
      extent = std::max(extent, (point(lerp(from, to, 1.0 * i / kPolePoints)) - start).norm());
    }
    if (!(extent <= kPoleExtent * extent_of(box))) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("its boundary does not close: it ends at {} and goes on at {}",
                              point_text(start), point_text(point(to))));
    }
    FaceEdge side;
    const gp_Pnt2d origin(from.u, from.v);
    const gp_Vec2d step(to.u - from.u, to.v - from.v);
    side.curve.curve = new Geom2d_Line(origin, gp_Dir2d(step));
    side.curve.last = step.Magnitude();
    side.vertex =
        before.is_forward ? TopExp::LastVertex(before.edge) : TopExp::FirstVertex(before.edge);
    return side;
  }

  Vec3 point(Uv uv) const { return to_vec3(surface_->Value(uv.u, uv.v)); }

  double extent_of(const LoopBox& box) const {
    return std::max((point({box.u0, box.v0}) - point({box.u1, box.v1})).norm(),
                    (point({box.u0, box.v1}) - point({box.u1, box.v0})).norm());
  }

  void shift_holes() {
    const LoopBox outer = box_of(result_.loops.front());
    for (std::size_t h = 1; h < result_.loops.size(); ++h) {
      FaceLoop& hole = result_.loops[h];
      const Uv step = outer.shift_inside(box_of(hole), periods_.u, periods_.v);
      for (FaceEdge& edge : hole) shift(edge, step);
    }
  }

  /// The box of the loops, within what the surface has.
  void set_domain() {
    LoopBox box = box_of(result_.loops.front());
    for (const FaceLoop& loop : result_.loops) box.extend(box_of(loop));
    double u0, u1, v0, v1;
    surface_->Bounds(u0, u1, v0, v1);
    if (periods_.u == 0) box.u0 = std::max(box.u0, u0), box.u1 = std::min(box.u1, u1);
    if (periods_.v == 0) box.v0 = std::max(box.v0, v0), box.v1 = std::min(box.v1, v1);
    if (!(box.width() > 0) || !(box.height() > 0)) {
      throw Error(ErrorCode::Geometry, "its boundary has no extent in its parameters");
    }
    result_.domain = {box.u0, box.u1, box.v0, box.v1};
  }

  TopoDS_Face face_;
  Handle(Geom_Surface) surface_;
  Periods periods_;
  std::vector<std::optional<FaceEdge>> poles_;
  FaceBoundary result_;
};

}  // namespace

FaceBoundary face_boundary(const TopoDS_Face& face) { return Boundary(face).make(); }

}  // namespace surfmesh
