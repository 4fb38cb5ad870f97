// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_mesh.hh"

#include <algorithm>
#include <bit>
#include <cmath>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/delaunay/spatial_order.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Steps of a walk, which starts near its end: a bound, for it may go astray by rounding.
constexpr int kWalkLimit = 2000;

/// Distance in cells of the grid of start triangles within which the last triangle is the better
/// start.
constexpr double kNearCells = 5;

NodeNeighbours neighbours_in(const PolyMesh& mesh) {
  std::vector<std::size_t> first = {0};
  std::vector<int> others;
  first.reserve(mesh.n_vertices() + 1);
  others.reserve(mesh.n_halfedges());
  for (const VertexHandle vh : mesh.vertices()) {
    for (const VertexHandle other : mesh.vv_range(vh)) others.push_back(other.idx());
    first.push_back(others.size());
  }
  return NodeNeighbours(std::move(first), std::move(others));
}

std::vector<MetricCorner> metrics_of(const std::vector<ControlNode>& nodes) {
  std::vector<MetricCorner> metrics;
  metrics.reserve(nodes.size());
  for (const ControlNode& node : nodes) {
    if (!is_regular(node.form)) continue;  // a pole has no metric
    metrics.push_back({node.uv, metric_from_size(node.form, node.size)});
  }
  return metrics;
}

FirstFormFactor mean_of(const FirstFormFactor& a, const FirstFormFactor& b) {
  return {0.5 * (a.l11 + b.l11), 0.5 * (a.l21 + b.l21), 0.5 * (a.l22 + b.l22)};
}

FirstFormFactor mean_of(const std::array<FirstFormFactor, 3>& forms) {
  const auto& [a, b, c] = forms;
  return {(a.l11 + b.l11 + c.l11) / 3, (a.l21 + b.l21 + c.l21) / 3, (a.l22 + b.l22 + c.l22) / 3};
}

}  // namespace

ControlMesh::ControlMesh(const Domain& domain, const std::vector<ControlNode>& nodes,
                         const ControlSpaceOptions& options)
    : ControlMesh(NodeTriangulation(domain, nodes), nodes, options) {}

ControlMesh::ControlMesh(NodeTriangulation&& triangulation, const std::vector<ControlNode>& nodes,
                         const ControlSpaceOptions& options)
    : ControlSpace(options, nodes) {
  std::vector<ControlNode> graded = triangulation.release_nodes();
  mesh_ = triangulation.release();
  if (options.grade > 0) grade_sizes(graded, neighbours_in(*mesh_), options.grade);
  store_node_metrics(metrics_of(graded));
  collect_nodes(graded);
  collect_triangles();
  make_seed_grid(triangulation.domain());
  const bool needs_circles = options.interpolation == Interpolation::Circles ||
                             options.interpolation == Interpolation::Automatic;
  if (needs_circles) collect_circles();
  if (options.interpolation == Interpolation::Automatic) {
    classify();
  } else {
    for (Triangle& t : triangles_) t.interpolation = options.interpolation;
  }
  write_nodes(graded);
  write_classes();
}

void ControlMesh::collect_nodes(const std::vector<ControlNode>& nodes) {
  std::vector<Uv> positions;
  positions.reserve(nodes.size());
  for (const ControlNode& from : nodes) positions.push_back(from.uv);
  const bool is_logarithmic = options().blend == Blend::Logarithmic;
  const bool looks_at_vertices = options().lookup == DiscLookup::Vertices;
  forms_.reserve(nodes.size());
  for (const ControlNode& from : nodes) forms_.push_back(from.form);
  node_of_.resize(nodes.size());
  nodes_.reserve(nodes.size());
  for (const int i : hilbert_order(positions)) {
    const ControlNode& from = nodes[static_cast<std::size_t>(i)];
    node_of_[static_cast<std::size_t>(i)] = static_cast<int>(nodes_.size());
    nodes_.push_back({from.uv, is_logarithmic ? log_size(from.size) : from.size});
    if (!looks_at_vertices) continue;
    const bool is_extended = from.radius + from.outer_radius > 0;
    extended_of_.push_back(is_extended ? static_cast<int>(extended_.size()) : -1);
    if (is_extended) extended_.push_back(from);
  }
}

void ControlMesh::collect_triangles() {
  // In the order of their least nodes, which lie along a curve: a sort by counting.
  const auto least_node = [this](FaceHandle fh) {
    int least = static_cast<int>(nodes_.size());
    for (const VertexHandle vh : vertices(*mesh_, fh)) {
      least = std::min(least, node_of_[index(vh)]);
    }
    return static_cast<std::size_t>(least);
  };
  std::vector<int> next(nodes_.size() + 1, 0);
  for (const FaceHandle fh : mesh_->faces()) ++next[least_node(fh) + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<int> triangle_of(mesh_->n_faces());
  face_of_.resize(mesh_->n_faces());
  for (const FaceHandle fh : mesh_->faces()) {
    const int place = next[least_node(fh)]++;
    triangle_of[index(fh)] = place;
    face_of_[static_cast<std::size_t>(place)] = fh.idx();
  }
  triangles_.resize(mesh_->n_faces());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    HalfedgeHandle heh = mesh_->halfedge_handle(FaceHandle(face_of_[i]));
    for (std::size_t k = 0; k < 3; ++k, heh = mesh_->next_halfedge_handle(heh)) {
      const FaceHandle behind = mesh_->opposite_face_handle(heh);
      triangles_[i].nodes[k] = node_of_[index(mesh_->from_vertex_handle(heh))];
      triangles_[i].neighbours[k] = behind.is_valid() ? triangle_of[index(behind)] : -1;
    }
  }
}

/// The circles of the triangulation, each in the mean spacing of the vertices as there.
void ControlMesh::collect_circles() {
  const auto uv = require(*mesh_, keys::vertex_uv);
  const auto spacing = require(*mesh_, keys::vertex_metric);
  circles_.reserve(triangles_.size());
  metrics_.reserve(triangles_.size());
  for (const int face : face_of_) {
    const auto [a, b, c] = vertices(*mesh_, FaceHandle(face));
    const Metric metric =
        mean(mesh_->property(spacing, a), mesh_->property(spacing, b), mesh_->property(spacing, c));
    metrics_.push_back(metric);
    circles_.push_back(circumcircle(
        {mesh_->property(uv, a), mesh_->property(uv, b), mesh_->property(uv, c)}, metric));
  }
}

void ControlMesh::write_nodes(const std::vector<ControlNode>& nodes) {
  detach(*mesh_, keys::vertex_metric);
  detach(*mesh_, keys::edge_constrained);
  const auto size = attach(*mesh_, keys::vertex_size);
  const auto inner_size = attach(*mesh_, keys::vertex_inner_size);
  const auto radius = attach(*mesh_, keys::vertex_radius);
  const auto outer_radius = attach(*mesh_, keys::vertex_outer_radius);
  for (const VertexHandle vh : mesh_->vertices()) {
    const ControlNode& from = nodes[index(vh)];
    mesh_->set_point(vh, to_openmesh(from.point));
    mesh_->property(size, vh) = from.size;
    mesh_->property(inner_size, vh) = from.inner;
    mesh_->property(radius, vh) = from.radius;
    mesh_->property(outer_radius, vh) = from.outer_radius;
  }
}

// --- classes ---

void ControlMesh::classify() {
  QueryHint hint;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    std::array<FirstFormFactor, 3> forms;
    HalfedgeHandle heh = mesh_->halfedge_handle(FaceHandle(face_of_[i]));
    for (std::size_t k = 0; k < 3; ++k, heh = mesh_->next_halfedge_handle(heh)) {
      forms[k] = form(mesh_->from_vertex_handle(heh).idx());
    }
    triangles_[i].interpolation = classify(static_cast<int>(i), forms, hint);
  }
}

/// The cheapest interpolation that agrees with V_o at the centroid and the middles of the edges.
/// Distances are taken through the mean first form of the vertices.
/// Source   paper, section 4.2
Interpolation ControlMesh::classify(int index, const std::array<FirstFormFactor, 3>& forms,
                                    QueryHint& hint) const {
  const Triangle& t = triangle(index);
  const std::array<Uv, 3> at = {node(t.nodes[0]).uv, node(t.nodes[1]).uv, node(t.nodes[2]).uv};
  const std::array<Probe, 4> probes = {Probe{(1.0 / 3.0) * (at[0] + at[1] + at[2]), mean_of(forms)},
                                       Probe{lerp(at[0], at[1], 0.5), mean_of(forms[0], forms[1])},
                                       Probe{lerp(at[1], at[2], 0.5), mean_of(forms[1], forms[2])},
                                       Probe{lerp(at[2], at[0], 0.5), mean_of(forms[2], forms[0])}};
  for (const Probe& probe : probes) {
    const SizeTensor h_o = from_circles(index, probe.uv, probe.form, hint);
    const SizeTensor h_t = from_vertices(t, probe.uv, probe.form);
    if (!(entry_conformity(h_o, h_t) < options().epsilon)) return Interpolation::Circles;
  }
  const SizeTensor first = size_of(node(t.nodes[0]).value);
  for (const int i : {t.nodes[1], t.nodes[2]}) {
    if (!(entry_conformity(size_of(node(i).value), first) < options().epsilon)) {
      return Interpolation::Triangle;
    }
  }
  return Interpolation::Single;
}

void ControlMesh::write_classes() {
  const auto handle = attach(*mesh_, keys::face_class);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    mesh_->property(handle, FaceHandle(face_of_[i])) =
        static_cast<int>(triangles_[i].interpolation);
  }
}

// --- location ---

std::size_t ControlMesh::SeedGrid::cell(Uv uv) const {
  const double column = std::clamp((uv.u - lower.u) * cells_per_u, 0.0, side - 1.0);
  const double row = std::clamp((uv.v - lower.v) * cells_per_v, 0.0, side - 1.0);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
         static_cast<std::size_t>(column);
}

bool ControlMesh::SeedGrid::are_near(Uv a, Uv b) const {
  return std::abs(a.u - b.u) * cells_per_u + std::abs(a.v - b.v) * cells_per_v <= kNearCells;
}

void ControlMesh::make_seed_grid(const Domain& domain) {
  // Two cells a triangle: random queries of 80,000 triangles take 95 ns, with one cell 135, with
  // half a cell 330 (steps miss the near cache), with four cells more again.
  const int side = 1 + static_cast<int>(std::sqrt(2 * static_cast<double>(triangles_.size())));
  seeds_.lower = {domain.u0, domain.v0};
  seeds_.side = side;
  seeds_.cells_per_u = side / (domain.u1 - domain.u0);
  seeds_.cells_per_v = side / (domain.v1 - domain.v0);
  seeds_.triangles.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  RandomBits random;
  int found = 0;
  for (int row = 0; row < side; ++row) {
    for (int i = 0; i < side; ++i) {
      // There and back, so that steps are short.
      const int column = row % 2 == 0 ? i : side - 1 - i;
      const Uv centre = domain.at((column + 0.5) / side, (row + 0.5) / side);
      found = walk(centre, found, random).triangle;
      seeds_.triangles[static_cast<std::size_t>(row * side + column)] = found;
    }
  }
}

/// The neighbour of a triangle on the way to a point; -1 if the point lies in it, or beyond an open
/// side. At random where two neighbours lead on: a fixed choice was seen to cycle.
int ControlMesh::exit_towards(Uv uv, int from, int entered_from, RandomBits& random) const {
  const Triangle& t = triangle(from);
  const std::array<Uv, 3> to = {node(t.nodes[0]).uv - uv, node(t.nodes[1]).uv - uv,
                                node(t.nodes[2]).uv - uv};
  unsigned exits = 0;
  for (unsigned k = 0; k < 3; ++k) {
    // Not back, whatever rounding says of a point on the side.
    const bool can_leave = (t.neighbours[k] >= 0) & (t.neighbours[k] != entered_from);
    exits |= static_cast<unsigned>((cross(to[k], to[k == 2 ? 0 : k + 1]) < 0) & can_leave) << k;
  }
  if (exits == 0) return -1;
  const unsigned others = exits & (exits - 1);
  if (others != 0 && (random.next() & 1u) != 0) exits = others;
  return t.neighbours[static_cast<std::size_t>(std::countr_zero(exits))];
}

/// The triangle that contains a point up to rounding: for sizes a neighbour is as good.
ControlMesh::Walk ControlMesh::walk(Uv uv, int start, RandomBits& random) const {
  Walk walk{start};
  int entered_from = -1;
  for (; walk.steps < kWalkLimit; ++walk.steps) {
    const int next = exit_towards(uv, walk.triangle, entered_from, random);
    if (next < 0) break;
    entered_from = walk.triangle;
    walk.triangle = next;
  }
  return walk;
}

void ControlMesh::locate(Uv uv, QueryHint& hint) const {
  const bool is_known = static_cast<std::size_t>(hint.element) < triangles_.size();
  const bool is_near = is_known && seeds_.are_near(node(triangle(hint.element).nodes[0]).uv, uv);
  const int start = is_near ? hint.element : seeds_.triangles[seeds_.cell(uv)];
  const Walk walked = walk(uv, start, hint.random);
  hint.element = walked.triangle;
  ++hint.answers.walks;
  hint.answers.steps += static_cast<std::size_t>(walked.steps);
}

// --- interpolation ---

SizeTensor ControlMesh::interpolate(const SurfacePoint& at, QueryHint& hint) const {
  const Triangle& t = triangle(hint.element);
  switch (t.interpolation) {
    case Interpolation::Single:
      ++hint.answers.single;
      return size_of(node(t.nodes[0]).value);
    case Interpolation::Circles:
      ++hint.answers.circles;
      return from_circles(hint.element, at.uv, at.form, hint);
    case Interpolation::Linear:
      ++hint.answers.linear;
      return linear(t, at.uv);
    default:
      ++hint.answers.triangle;
      return from_vertices(t, at.uv, at.form);
  }
}

SizeTensor ControlMesh::size_of(const SizeTensor& value) const {
  return options().blend == Blend::Logarithmic ? exp_size(value) : value;
}

std::optional<SizeTensor> ControlMesh::extended_size_by_vertices(const SurfacePoint& at,
                                                                 const QueryHint& hint) const {
  std::optional<SizeTensor> least;
  if (extended_.empty()) return least;
  for (const int i : triangle(hint.element).nodes) {
    const int extended = extended_of_[static_cast<std::size_t>(i)];
    if (extended < 0) continue;
    const auto size = extended_size(extended_[static_cast<std::size_t>(extended)], at.point);
    if (size) least = least ? minimum(*least, *size) : *size;
  }
  return least;
}

SizeTensor ControlMesh::from_vertices(const Triangle& t, Uv uv, const FirstFormFactor& form) const {
  const Node &a = node(t.nodes[0]), &b = node(t.nodes[1]), &c = node(t.nodes[2]);
  return size_of(surfmesh::interpolate(
      std::array{a.value, b.value, c.value},
      std::array{squared_distance(form, uv - a.uv), squared_distance(form, uv - b.uv),
                 squared_distance(form, uv - c.uv)}));
}

SizeTensor ControlMesh::linear(const Triangle& t, Uv uv) const {
  const Node &a = node(t.nodes[0]), &b = node(t.nodes[1]), &c = node(t.nodes[2]);
  return size_of(interpolate_linearly({a.value, b.value, c.value}, {a.uv, b.uv, c.uv}, uv));
}

SizeTensor ControlMesh::from_circles(int index, Uv uv, const FirstFormFactor& form,
                                     QueryHint& hint) const {
  collect_cavity(index, uv, hint);
  const std::size_t count = hint.cavity_nodes.size();
  hint.sizes.resize(count);
  hint.squared_distances.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Node& from = node(hint.cavity_nodes[i]);
    hint.sizes[i] = from.value;
    hint.squared_distances[i] = squared_distance(form, uv - from.uv);
  }
  return size_of(surfmesh::interpolate(std::span<const SizeTensor>(hint.sizes),
                                       std::span<const double>(hint.squared_distances)));
}

bool ControlMesh::is_in_circle(int index, Uv uv) const {
  const auto i = static_cast<std::size_t>(index);
  return squared_length(metrics_[i], uv - circles_[i].centre) < circles_[i].squared_radius;
}

/// The node of a triangle that does not lie on its side to a neighbour.
int ControlMesh::node_opposite(int index, int neighbour) const {
  const Triangle& t = triangle(index);
  const std::size_t side =
      t.neighbours[0] == neighbour ? 0 : (t.neighbours[1] == neighbour ? 1 : 2);
  return t.nodes[side == 0 ? 2 : side - 1];
}

/// Collect the nodes of all triangles around a point whose circumcircles contain it; the containing
/// triangle counts always.
void ControlMesh::collect_cavity(int index, Uv uv, QueryHint& hint) const {
  std::vector<int>& cavity = hint.cavity;
  std::vector<int>& found = hint.cavity_nodes;
  cavity.assign(1, index);
  found.assign(triangle(index).nodes.begin(), triangle(index).nodes.end());
  const auto is_in = [](const std::vector<int>& list, int x) {
    return std::find(list.begin(), list.end(), x) != list.end();
  };
  for (std::size_t i = 0; i < cavity.size(); ++i) {
    for (const int behind : triangle(cavity[i]).neighbours) {
      // The circle first: it says no most often, but for the triangle that led here.
      if (behind < 0 || !is_in_circle(behind, uv) || is_in(cavity, behind)) continue;
      cavity.push_back(behind);
      const int apex = node_opposite(behind, cavity[i]);
      if (!is_in(found, apex)) found.push_back(apex);
    }
  }
}

}  // namespace surfmesh
