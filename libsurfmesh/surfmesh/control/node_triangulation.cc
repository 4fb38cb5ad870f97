// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/node_triangulation.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/delaunay/spatial_order.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Nodes nearer than this share of the size wanted there become one.
constexpr double kMergeLength = 0.1;

/// Square of the greatest circumradius over the shortest edge: from √2 on refinement ends.
constexpr double kBadShape = 2;

/// Sides shorter than this share of the domain are not divided.
constexpr double kTinyShare = 1e-6;

/// Bound of refinement where the spacing changes, for then it need not end.
constexpr std::size_t kMostInnerNodes = 8;

/// Sizes of two nodes at one place.
void merge(ControlNode& old, const ControlNode& other) {
  old.size = minimum(old.size, other.size);
  if (!std::isfinite(other.inner.h11)) return;
  const auto least = [](const SizeTensor& a, const SizeTensor& b) {
    return !std::isfinite(a.h11) ? b : !std::isfinite(b.h11) ? a : minimum(a, b);
  };
  old.inner = least(old.inner, other.inner);
  old.outer = least(old.outer, other.outer);
  old.radius = std::max(old.radius, other.radius);
  old.outer_radius = std::max(old.outer_radius, other.outer_radius);
}

bool is_corner(const Domain& domain, Uv uv) {
  return (uv.u == domain.u0 || uv.u == domain.u1) && (uv.v == domain.v0 || uv.v == domain.v1);
}

bool comes_alone(const ControlNode& node) { return !std::isfinite(node.spacing.m11); }

/// What the triangulation begins with: regular rows, or the rectangle alone.
std::vector<Uv> first_points(const Domain& domain, const std::vector<ControlNode>& nodes,
                             const RegularRows& rows) {
  if (rows.count() == 0) {
    return {{domain.u0, domain.v0},
            {domain.u1, domain.v0},
            {domain.u1, domain.v1},
            {domain.u0, domain.v1}};
  }
  std::vector<Uv> points;
  points.reserve(rows.count());
  for (std::size_t i = 0; i < rows.count(); ++i) points.push_back(nodes[i].uv);
  return points;
}

std::vector<std::array<int, 3>> first_triangles(const RegularRows& rows) {
  if (rows.count() == 0) return {{0, 1, 2}, {0, 2, 3}};
  return triangles_between(rows);
}

bool is_badly_shaped(const std::array<Uv, 3>& triangle, const Metric& m, double squared_radius) {
  const auto& [a, b, c] = triangle;
  const double shortest =
      std::min({squared_length(m, b - a), squared_length(m, c - b), squared_length(m, a - c)});
  return squared_radius > kBadShape * shortest;
}

}  // namespace

Metric plane_metric(const std::vector<ControlNode>& nodes) {
  double along_u = 0, along_v = 0;
  for (const ControlNode& node : nodes) {
    along_u += node.form.l11 * node.form.l11;
    along_v += node.form.l21 * node.form.l21 + node.form.l22 * node.form.l22;
  }
  return {along_u, 0, along_v};
}

NodeTriangulation::NodeTriangulation(const Domain& domain, const std::vector<ControlNode>& nodes)
    : NodeTriangulation(domain, nodes, find_regular_rows(domain, nodes)) {}

NodeTriangulation::NodeTriangulation(const Domain& domain, const std::vector<ControlNode>& nodes,
                                     const RegularRows& rows)
    : domain_(domain),
      delaunay_(first_points(domain, nodes, rows), first_triangles(rows)),
      rule_{delaunay_.uv_handle(), delaunay_.metric_handle()},
      nodes_(delaunay_.n_vertices()) {
  const Metric first = rows.count() > 0 ? nodes[0].spacing : plane_metric(nodes);
  for (std::size_t i = 0; i < delaunay_.n_vertices(); ++i) {
    delaunay_.metric(VertexHandle(static_cast<int>(i))) = first;
  }
  std::copy_n(nodes.begin(), rows.count(), nodes_.begin());
  if (rows.count() < nodes.size()) insert_all(std::span(nodes).subspan(rows.count()));
}

/// Corners first, so that no other node takes their place; then those with which nodes that come
/// alone may be merged.
void NodeTriangulation::insert_all(std::span<const ControlNode> nodes) {
  delaunay_.reserve(nodes.size());
  nodes_.reserve(nodes_.size() + nodes.size());
  std::vector<Uv> positions;
  positions.reserve(nodes.size());
  for (const ControlNode& node : nodes) positions.push_back(node.uv);
  const std::vector<int> order = spatial_order(positions);
  for (const bool is_at_corner : {true, false}) {
    for (const bool is_alone : {false, true}) {
      for (const int i : order) {
        const ControlNode& node = nodes[static_cast<std::size_t>(i)];
        if (is_corner(domain_, node.uv) == is_at_corner && comes_alone(node) == is_alone) {
          insert(node);
        }
      }
    }
  }
  delaunay_.shrink();
}

void NodeTriangulation::insert(const ControlNode& node) {
  const Location location = delaunay_.locate(node.uv, hint_);
  if (location.kind == Location::Kind::Outside) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a control node at (u,v) = ({}, {}) lies outside the domain", node.uv.u,
                            node.uv.v));
  }
  hint_ = location.face;
  const bool is_there = location.kind == Location::Kind::OnVertex;
  if (!is_there && comes_alone(node) && merge_with_neighbour(node, location.face)) return;
  const Metric spacing = comes_alone(node) ? around(location.face) : node.spacing;
  const VertexHandle vh = delaunay_.insert(node.uv, location.face, rule_);
  if (index(vh) >= nodes_.size()) nodes_.resize(index(vh) + 1);
  ControlNode& slot = nodes_[index(vh)];
  if (std::isfinite(slot.size.h11)) {
    merge(slot, node);
  } else {
    slot = node;
    delaunay_.metric(vh) = slot.spacing = spacing;
  }
  hint_ = face_at(vh);
}

/// A triangle at a vertex; the vertex' own halfedge is the open one on the boundary.
FaceHandle NodeTriangulation::face_at(VertexHandle vh) const {
  const PolyMesh& mesh = delaunay_.mesh();
  const HalfedgeHandle heh = mesh.halfedge_handle(vh);
  return mesh.is_boundary(heh) ? mesh.opposite_face_handle(heh) : mesh.face_handle(heh);
}

/// Mean spacing of the vertices of a triangle.
Metric NodeTriangulation::around(FaceHandle fh) const {
  const auto [a, b, c] = vertices(delaunay_.mesh(), fh);
  return mean(delaunay_.metric(a), delaunay_.metric(b), delaunay_.metric(c));
}

/// Merge with a node nearby: the vertices of the triangle, and those opposite its sides.
bool NodeTriangulation::merge_with_neighbour(const ControlNode& node, FaceHandle fh) {
  const PolyMesh& mesh = delaunay_.mesh();
  HalfedgeHandle heh = mesh.halfedge_handle(fh);
  for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
    if (merge_with(node, mesh.to_vertex_handle(heh))) return true;
    const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
    if (mesh.is_boundary(opposite)) continue;
    if (merge_with(node, mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)))) return true;
  }
  return false;
}

/// Merge with the node of a vertex if the two are a tenth of the smaller size apart or less.
bool NodeTriangulation::merge_with(const ControlNode& node, VertexHandle vh) {
  ControlNode& old = nodes_[index(vh)];
  if (!std::isfinite(old.size.h11)) return false;  // a corner of the rectangle, not met yet
  const Uv step = node.uv - old.uv;
  for (const ControlNode* either : {&node, static_cast<const ControlNode*>(&old)}) {
    const double squared = squared_length(metric_from_size(either->form, either->size), step);
    if (squared >= kMergeLength * kMergeLength) return false;
  }
  merge(old, node);
  return true;
}

std::vector<Uv> NodeTriangulation::add_inner_nodes() {
  std::vector<FaceHandle> stack;
  for (std::size_t i = 0; i < delaunay_.n_faces(); ++i) stack.emplace_back(static_cast<int>(i));
  std::vector<Uv> added;
  while (!stack.empty() && added.size() < kMostInnerNodes * nodes_.size()) {
    const FaceHandle fh = stack.back();
    stack.pop_back();
    const VertexHandle vh = improve(fh);
    if (!vh.is_valid()) continue;
    added.push_back(delaunay_.uv(vh));
    for (const FaceHandle around : delaunay_.mesh().vf_range(vh)) stack.push_back(around);
    stack.push_back(fh);
  }
  delaunay_.shrink();
  return added;
}

/// True if a triangle has a side that is nothing beside the domain.
bool NodeTriangulation::is_tiny(const std::array<Uv, 3>& triangle) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Uv side = triangle[(k + 1) % 3] - triangle[k];
    if (std::abs(side.u) < kTinyShare * (domain_.u1 - domain_.u0) &&
        std::abs(side.v) < kTinyShare * (domain_.v1 - domain_.v0)) {
      return true;
    }
  }
  return false;
}

/// Insert the node that a badly shaped triangle needs; an invalid handle if it needs none.
VertexHandle NodeTriangulation::improve(FaceHandle fh) {
  const Metric metric = around(fh);
  const std::array<Uv, 3> triangle = corners(delaunay_.mesh(), fh, delaunay_.uv_handle());
  const MetricCircle circle = circumcircle(triangle, metric);
  if (!is_badly_shaped(triangle, metric, circle.squared_radius)) return VertexHandle();
  // Rounding may leave a triangle without area. Beside cells of other sizes, sides at the boundary
  // of the domain are halved down to rounding.
  if (!std::isfinite(circle.squared_radius) || is_tiny(triangle)) return VertexHandle();
  const auto middle = [this](HalfedgeHandle heh) {
    const PolyMesh& mesh = delaunay_.mesh();
    return lerp(delaunay_.uv(mesh.from_vertex_handle(heh)),
                delaunay_.uv(mesh.to_vertex_handle(heh)), 0.5);
  };
  const Location location = delaunay_.locate(circle.centre, fh);
  if (location.kind == Location::Kind::OnVertex) return VertexHandle();
  if (location.kind == Location::Kind::Outside) {
    return insert_alone(middle(location.edge), location.face);
  }
  Cavity cavity;
  delaunay_.find_cavity(circle.centre, location, rule_, cavity);
  for (const HalfedgeHandle heh : cavity.rim) {
    const PolyMesh& mesh = delaunay_.mesh();
    if (!mesh.is_boundary(mesh.opposite_halfedge_handle(heh))) continue;
    const Uv a = delaunay_.uv(mesh.from_vertex_handle(heh)) - circle.centre;
    const Uv b = delaunay_.uv(mesh.to_vertex_handle(heh)) - circle.centre;
    // Within the circle over the edge: a node there would leave a flat triangle at the rim.
    if (inner_product(metric, a, b) < 0) return insert_alone(middle(heh), mesh.face_handle(heh));
  }
  return insert_alone(circle.centre, location.face);
}

/// Insert a node with the spacing of the triangle around; an invalid handle if there is one.
VertexHandle NodeTriangulation::insert_alone(Uv uv, FaceHandle fh) {
  const std::size_t before = delaunay_.n_vertices();
  const Metric spacing = around(fh);
  const VertexHandle vh = delaunay_.insert(uv, fh, rule_);
  if (delaunay_.n_vertices() == before) return VertexHandle();
  delaunay_.metric(vh) = spacing;
  return vh;
}

}  // namespace surfmesh
