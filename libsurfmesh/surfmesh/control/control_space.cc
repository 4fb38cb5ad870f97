// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_space.hh"

#include <fmt/format.h>

#include <algorithm>
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
    hint_ = delaunay_.mesh().face_handle(delaunay_.mesh().halfedge_handle(vh));
  }

  DelaunayMesh& delaunay() { return delaunay_; }
  const std::vector<ControlNode>& nodes() const { return nodes_; }

 private:
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
      const SizeTensor lowered =
          graded(old, size, std::sqrt(squared_length(metric, edge)), grade);
      if (log_conformity(old, lowered) <= kLeastGradation) continue;
      old = lowered;
      char& queued = is_queued[static_cast<std::size_t>(to.idx())];
      if (!queued) queue.push_back(to);
      queued = 1;
    }
  }
}

int ControlSpace::SeedGrid::column(double u) const {
  return std::clamp(static_cast<int>((u - lower.u) * columns_per_u), 0, columns - 1);
}

int ControlSpace::SeedGrid::row(double v) const {
  return std::clamp(static_cast<int>((v - lower.v) * rows_per_v), 0, rows - 1);
}

void ControlSpace::make_seed_grid(const Domain& domain) {
  // About two triangles a cell: finer grids cost memory and gain less than a step.
  const int side = 1 + static_cast<int>(std::sqrt(0.5 * static_cast<double>(mesh_.n_faces())));
  seeds_.lower = {domain.u0, domain.v0};
  seeds_.columns = seeds_.rows = side;
  seeds_.columns_per_u = side / (domain.u1 - domain.u0);
  seeds_.rows_per_v = side / (domain.v1 - domain.v0);
  seeds_.faces.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  RandomBits random;
  FaceHandle face(0);
  for (int row = 0; row < side; ++row) {
    for (int i = 0; i < side; ++i) {
      const int column = row % 2 == 0 ? i : side - 1 - i;  // there and back, so that steps are short
      const Uv centre = domain.at((column + 0.5) / side, (row + 0.5) / side);
      face = locate(mesh_, uv_, centre, face, random, mesh_.n_faces()).face;
      seeds_.faces[static_cast<std::size_t>(row * side + column)] = face;
    }
  }
}

FaceHandle ControlSpace::find_face(Uv uv, Hint& hint) const {
  const int column = seeds_.column(uv.u), row = seeds_.row(uv.v);
  FaceHandle start = hint.face;
  if (start.is_valid()) {
    const Uv near = mesh_.property(uv_, mesh_.to_vertex_handle(mesh_.halfedge_handle(start)));
    const bool is_near =
        std::abs(seeds_.column(near.u) - column) + std::abs(seeds_.row(near.v) - row) <= 2;
    if (!is_near) start.invalidate();
  }
  if (!start.is_valid()) {
    start = seeds_.faces[static_cast<std::size_t>(row * seeds_.columns + column)];
  }
  hint.face = walk(mesh_, uv_, uv, start, hint.random);
  return hint.face;
}

SizeTensor ControlSpace::size(Uv uv, const FirstFormFactor& form, Hint& hint) const {
  const FaceHandle fh = find_face(uv, hint);
  const HalfedgeHandle a = mesh_.halfedge_handle(fh);
  const HalfedgeHandle b = mesh_.next_halfedge_handle(a);
  const HalfedgeHandle c = mesh_.next_halfedge_handle(b);
  std::array<SizeTensor, 3> sizes;
  std::array<double, 3> distances{};
  std::size_t k = 0;
  for (const HalfedgeHandle heh : {a, b, c}) {
    const VertexHandle vh = mesh_.to_vertex_handle(heh);
    sizes[k] = mesh_.property(size_, vh);
    distances[k] = squared_distance(form, uv - mesh_.property(uv_, vh));
    ++k;
  }
  return interpolate(sizes, distances);
}

Metric ControlSpace::metric(Uv uv, const FirstFormFactor& form, Hint& hint) const {
  return metric_from_size(form, size(uv, form, hint));
}

}  // namespace surfmesh
