// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_space.hh"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>

#include "surfmesh/core/error.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/delaunay/spatial_order.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/gradation.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Nodes nearer than this share of the size wanted there become one.
constexpr double kMergeLength = 0.1;

/// A size that gradation lowers by less is left as it is, so that it ends.
constexpr double kLeastGradation = 1e-3;

/// Steps of a walk, which starts near its end: a bound, for it may go astray by rounding.
constexpr int kWalkLimit = 2000;

/// Distance in cells of the grid of start triangles within which the last triangle is the better
/// start.
constexpr double kNearCells = 3;

/// The diagonal metric in which the parameter plane is distorted least: mean squared speeds.
Metric plane_metric(const std::vector<ControlNode>& nodes) {
  double along_u = 0, along_v = 0;
  for (const ControlNode& node : nodes) {
    along_u += node.form.l11 * node.form.l11;
    along_v += node.form.l21 * node.form.l21 + node.form.l22 * node.form.l22;
  }
  return {along_u, 0, along_v};
}

/// Inserts nodes one by one and keeps what belongs to each vertex.
class NodeInsertion {
 public:
  /// `plane` shapes the triangles where nodes tell no spacing.
  NodeInsertion(const Domain& domain, const Metric& plane)
      : delaunay_({domain.u0, domain.v0}, {domain.u1, domain.v1}),
        rule_{delaunay_.uv_handle(), delaunay_.metric_handle()},
        nodes_(4) {
    for (int i = 0; i < 4; ++i) delaunay_.metric(VertexHandle(i)) = plane;
  }

  void reserve(std::size_t count) { delaunay_.reserve(count); }

  void insert(const ControlNode& node) {
    const Location location = delaunay_.locate(node.uv, hint_);
    if (location.kind == Location::Kind::Outside) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("a control node at (u,v) = ({}, {}) lies outside the domain",
                              node.uv.u, node.uv.v));
    }
    hint_ = location.face;
    const bool is_corner = location.kind == Location::Kind::OnVertex && location.vertex.idx() < 4;
    if (!is_corner && merge_with_neighbour(node, location.face)) return;
    const Metric spacing = std::isfinite(node.spacing.m11) ? node.spacing : around(location.face);
    const VertexHandle vh = delaunay_.insert(node.uv, location.face, rule_);
    const auto index = static_cast<std::size_t>(vh.idx());
    if (index >= nodes_.size()) nodes_.resize(index + 1);
    const bool is_first = !std::isfinite(nodes_[index].size.h11);
    const SizeTensor size = is_first ? node.size : minimum(nodes_[index].size, node.size);
    nodes_[index] = node;
    nodes_[index].size = size;
    delaunay_.metric(vh) = spacing;
    hint_ = face_at(vh);
  }

  DelaunayMesh& delaunay() { return delaunay_; }
  const std::vector<ControlNode>& nodes() const { return nodes_; }

 private:
  /// A triangle at a vertex; the vertex' own halfedge is the open one on the boundary.
  FaceHandle face_at(VertexHandle vh) const {
    const TriMesh& mesh = delaunay_.mesh();
    const HalfedgeHandle heh = mesh.halfedge_handle(vh);
    return mesh.is_boundary(heh) ? mesh.opposite_face_handle(heh) : mesh.face_handle(heh);
  }

  /// Mean spacing of the vertices of a triangle.
  Metric around(FaceHandle fh) const {
    const TriMesh& mesh = delaunay_.mesh();
    const HalfedgeHandle a = mesh.halfedge_handle(fh);
    const HalfedgeHandle b = mesh.next_halfedge_handle(a);
    const HalfedgeHandle c = mesh.next_halfedge_handle(b);
    return mean(delaunay_.metric(mesh.to_vertex_handle(a)),
                delaunay_.metric(mesh.to_vertex_handle(b)),
                delaunay_.metric(mesh.to_vertex_handle(c)));
  }

  bool merge_with_neighbour(const ControlNode& node, FaceHandle fh) {
    const Metric metric = metric_from_size(node.form, node.size);
    for (const VertexHandle vh : delaunay_.mesh().fv_range(fh)) {
      ControlNode& old = nodes_[static_cast<std::size_t>(vh.idx())];
      if (!std::isfinite(old.size.h11)) continue;  // a corner of the rectangle, not met yet
      if (squared_length(metric, node.uv - old.uv) >= kMergeLength * kMergeLength) continue;
      old.size = minimum(old.size, node.size);
      return true;
    }
    return false;
  }

  DelaunayMesh delaunay_;
  TriangleMetricRule rule_;
  std::vector<ControlNode> nodes_;
  FaceHandle hint_ = FaceHandle(0);
};

}  // namespace

ControlSpace::ControlSpace(const Domain& domain, const std::vector<ControlNode>& nodes,
                           double grade) {
  triangulate(domain, nodes);
  if (grade > 0) grade_sizes(grade);
  collect_triangles();
  make_seed_grid(domain);
}

void ControlSpace::triangulate(const Domain& domain, const std::vector<ControlNode>& nodes) {
  NodeInsertion insertion(domain, plane_metric(nodes));
  insertion.reserve(nodes.size());
  std::vector<Uv> positions;
  positions.reserve(nodes.size());
  for (const ControlNode& node : nodes) positions.push_back(node.uv);
  // Corners first, so that no other node takes their place.
  for (const ControlNode& node : nodes) {
    const bool is_corner = (node.uv.u == domain.u0 || node.uv.u == domain.u1) &&
                           (node.uv.v == domain.v0 || node.uv.v == domain.v1);
    if (is_corner) insertion.insert(node);
  }
  for (const int i : spatial_order(positions)) insertion.insert(nodes[static_cast<std::size_t>(i)]);

  insertion.delaunay().shrink();
  mesh_ = insertion.delaunay().mesh();
  detach(mesh_, keys::vertex_metric);
  detach(mesh_, keys::edge_constrained);
  uv_ = require(mesh_, keys::vertex_uv);
  size_ = attach(mesh_, keys::vertex_size);
  forms_.resize(mesh_.n_vertices());
  for (const VertexHandle vh : mesh_.vertices()) {
    const ControlNode& node = insertion.nodes()[static_cast<std::size_t>(vh.idx())];
    mesh_.property(size_, vh) = node.size;
    mesh_.set_point(vh, to_openmesh(node.point));
    forms_[static_cast<std::size_t>(vh.idx())] = node.form;
  }
}

void ControlSpace::grade_sizes(double grade) {
  std::deque<VertexHandle> queue;
  std::vector<char> is_queued(mesh_.n_vertices(), 1);
  for (const VertexHandle vh : mesh_.vertices()) queue.push_back(vh);
  while (!queue.empty()) {
    const VertexHandle from = queue.front();
    queue.pop_front();
    is_queued[static_cast<std::size_t>(from.idx())] = 0;
    const SizeTensor size = mesh_.property(size_, from);
    const Metric metric = metric_from_size(forms_[static_cast<std::size_t>(from.idx())], size);
    for (const VertexHandle to : mesh_.vv_range(from)) {
      const Uv edge = mesh_.property(uv_, to) - mesh_.property(uv_, from);
      SizeTensor& old = mesh_.property(size_, to);
      const SizeTensor lowered = graded(old, size, std::sqrt(squared_length(metric, edge)), grade);
      if (log_conformity(old, lowered) <= kLeastGradation) continue;
      old = lowered;
      char& queued = is_queued[static_cast<std::size_t>(to.idx())];
      if (!queued) queue.push_back(to);
      queued = 1;
    }
  }
}

void ControlSpace::collect_triangles() {
  std::vector<Uv> middles;
  middles.reserve(mesh_.n_faces());
  for (const FaceHandle fh : mesh_.faces()) {
    const auto [a, b, c] = corners(mesh_, fh, uv_);
    middles.push_back((1.0 / 3.0) * (a + b + c));
  }
  const std::vector<int> order = hilbert_order(middles);
  std::vector<int> position(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    position[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  }
  triangles_.resize(order.size());
  for (const FaceHandle fh : mesh_.faces()) {
    const auto index = static_cast<std::size_t>(fh.idx());
    Triangle& triangle = triangles_[static_cast<std::size_t>(position[index])];
    HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    for (std::size_t k = 0; k < 3; ++k, heh = mesh_.next_halfedge_handle(heh)) {
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      const FaceHandle behind = mesh_.opposite_face_handle(heh);
      triangle.corners[k] = mesh_.property(uv_, vh);
      triangle.sizes[k] = mesh_.property(size_, vh);
      if (behind.is_valid()) {
        triangle.neighbours[k] = position[static_cast<std::size_t>(behind.idx())];
      }
    }
  }
}

std::size_t ControlSpace::SeedGrid::cell(Uv uv) const {
  const double column = std::clamp((uv.u - lower.u) * cells_per_u, 0.0, side - 1.0);
  const double row = std::clamp((uv.v - lower.v) * cells_per_v, 0.0, side - 1.0);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
         static_cast<std::size_t>(column);
}

bool ControlSpace::SeedGrid::are_near(Uv a, Uv b) const {
  return std::abs(a.u - b.u) * cells_per_u + std::abs(a.v - b.v) * cells_per_v <= kNearCells;
}

void ControlSpace::make_seed_grid(const Domain& domain) {
  // About two triangles a cell: finer grids cost memory and gain less than a step.
  const int side = 1 + static_cast<int>(std::sqrt(0.5 * static_cast<double>(triangles_.size())));
  seeds_.lower = {domain.u0, domain.v0};
  seeds_.side = side;
  seeds_.cells_per_u = side / (domain.u1 - domain.u0);
  seeds_.cells_per_v = side / (domain.v1 - domain.v0);
  seeds_.triangles.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  RandomBits random;
  int triangle = 0;
  for (int row = 0; row < side; ++row) {
    for (int i = 0; i < side; ++i) {
      const int column =
          row % 2 == 0 ? i : side - 1 - i;  // there and back, so that steps are short
      const Uv centre = domain.at((column + 0.5) / side, (row + 0.5) / side);
      triangle = walk(centre, triangle, random);
      seeds_.triangles[static_cast<std::size_t>(row * side + column)] = triangle;
    }
  }
}

/// The neighbour of a triangle on the way to a point; -1 if the point lies in it, or beyond an open
/// side. At random where two neighbours lead on: a fixed choice was seen to cycle.
int ControlSpace::exit_towards(Uv uv, int triangle, int entered_from, RandomBits& random) const {
  const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  unsigned exits = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const Uv a = t.corners[k], b = t.corners[k == 2 ? 0 : k + 1];
    // Not back, whatever rounding says of a point on the side.
    const bool can_leave = (t.neighbours[k] >= 0) & (t.neighbours[k] != entered_from);
    exits |= static_cast<unsigned>((cross(b - a, uv - a) < 0) & can_leave) << k;
  }
  if (exits == 0) return -1;
  const unsigned others = exits & (exits - 1);
  if (others != 0 && (random.next() & 1u) != 0) exits = others;
  return t.neighbours[static_cast<std::size_t>(std::countr_zero(exits))];
}

/// The triangle that contains a point up to rounding: for sizes a neighbour is as good.
int ControlSpace::walk(Uv uv, int start, RandomBits& random) const {
  int triangle = start, entered_from = -1;
  for (int steps = 0; steps < kWalkLimit; ++steps) {
    const int next = exit_towards(uv, triangle, entered_from, random);
    if (next < 0) break;
    entered_from = triangle;
    triangle = next;
  }
  return triangle;
}

const ControlSpace::Triangle& ControlSpace::find_triangle(Uv uv, Hint& hint) const {
  const auto last = static_cast<std::size_t>(hint.triangle);
  const bool is_near = last < triangles_.size() && seeds_.are_near(triangles_[last].corners[0], uv);
  const int start = is_near ? hint.triangle : seeds_.triangles[seeds_.cell(uv)];
  hint.triangle = walk(uv, start, hint.random);
  return triangles_[static_cast<std::size_t>(hint.triangle)];
}

SizeTensor ControlSpace::size(Uv uv, const FirstFormFactor& form, Hint& hint) const {
  const Triangle& triangle = find_triangle(uv, hint);
  const auto& [a, b, c] = triangle.corners;
  return interpolate(triangle.sizes,
                     std::array{squared_distance(form, uv - a), squared_distance(form, uv - b),
                                squared_distance(form, uv - c)});
}

Metric ControlSpace::metric(Uv uv, const FirstFormFactor& form, Hint& hint) const {
  return metric_from_size(form, size(uv, form, hint));
}

}  // namespace surfmesh
