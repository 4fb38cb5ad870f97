// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/lattice_space.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Units of a size at a point to which cells are divided around it where sizes are not graded.
constexpr double kUnitsAroundPoint = 2;

/// Units of a size that another node of a row is away at most to be joined to it, and nodes in all.
constexpr double kLongestJoint = 2;
constexpr std::size_t kMostJoined = 10'000;

/// Share of the way from a to b of the point nearest to p in a metric.
double nearest_share(const Metric& metric, Uv a, Uv b, Uv p) {
  const double squared = squared_length(metric, b - a);
  if (!(squared > 0)) return 0;
  return std::clamp(inner_product(metric, b - a, p - a) / squared, 0.0, 1.0);
}

}  // namespace

LatticeSpace::LatticeSpace(const Domain& domain, const ControlSpaceOptions& options,
                           const std::vector<ControlNode>& discs)
    : ControlSpace(options, discs),
      domain_(domain),
      uv_(attach(mesh_, keys::vertex_uv)),
      size_(attach(mesh_, keys::vertex_size)) {}

int LatticeSpace::add_node(const ControlNode& node) {
  const VertexHandle vh = mesh_.add_vertex(to_openmesh(node.point));
  mesh_.property(uv_, vh) = node.uv;
  mesh_.property(size_, vh) = node.size;
  forms_.push_back(node.form);
  return vh.idx();
}

void LatticeSpace::change_sizes(const ChangeSize& change) {
  for (int node = 0; node < node_count(); ++node) {
    const SurfacePoint at = surface_point(node);
    set_size(node, change({at.uv, at.point, at.form, size(node), {}}));
  }
}

std::vector<int> LatticeSpace::nodes_from(int first) const {
  std::vector<int> nodes(static_cast<std::size_t>(node_count() - first));
  std::iota(nodes.begin(), nodes.end(), first);
  return nodes;
}

SurfacePoint LatticeSpace::surface_point(int node) const {
  return {uv(node), to_eigen(mesh_.point(VertexHandle(node))), form(node)};
}

// --- rows ---

int LatticeSpace::add_row_node(const ControlNode& node, int before) {
  const int added = add_node(node);
  announce_loose_node();
  segments_.push_back({before < 0 ? added : before, added});
  return added;
}

int LatticeSpace::insert_row_node(const ControlNode& node, int from, int to) {
  const int added = add_row_node(node, from);
  const auto split = std::find_if(
      segments_.begin(), segments_.end(),
      [=](const RowSegment& segment) { return segment.from == from && segment.to == to; });
  split->from = added;
  return added;
}

/// Tell which nodes a row's sizes are passed on to. Cells may have been divided since the last
/// time.
void LatticeSpace::link_rows() {
  row_neighbours_.clear();
  const auto link = [this](int a, int b) {
    row_neighbours_[a].push_back(b);
    row_neighbours_[b].push_back(a);
  };
  int near = -1;
  for (const RowSegment& segment : segments_) {
    if (segment.from != segment.to) link(segment.from, segment.to);
    const Support around = support(uv(segment.to), near);
    near = around.cell;
    for (const int node : around.nodes) {
      if (node >= 0) link(segment.to, node);
    }
  }
}

/// Give the segments of rows to the cells that they cross, found by points along them.
void LatticeSpace::assign_rows() {
  constexpr int kSteps = 4;
  segments_of_.clear();
  int near = -1;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    for (int i = 0; i <= kSteps; ++i) {
      const Uv at = lerp(uv(segments_[k].from), uv(segments_[k].to), double(i) / kSteps);
      near = support(at, near).cell;
      std::vector<int>& here = segments_of_[near];
      if (here.empty() || here.back() != static_cast<int>(k)) here.push_back(static_cast<int>(k));
    }
  }
}

SizeTensor LatticeSpace::limited_by(const RowSegment& segment, const SizeTensor& size,
                                    const SurfacePoint& at) const {
  const Uv a = uv(segment.from), b = uv(segment.to);
  const Metric plane = metric_from_size(at.form, isotropic(1));
  const double share = nearest_share(plane, a, b, at.uv);
  const SizeTensor there = lerp(this->size(segment.from), this->size(segment.to), share);
  const Metric metric = metric_from_size(at.form, there);
  const double length_m = std::sqrt(squared_length(metric, at.uv - lerp(a, b, share)));
  return limited_size(size, there, 1 + std::log(options().grade) * length_m);
}

SizeTensor LatticeSpace::limited_by_rows(const SizeTensor& size, const SurfacePoint& at,
                                         int cell) const {
  const auto found = segments_of_.find(cell);
  if (found == segments_of_.end() || !is_regular(at.form)) return size;
  SizeTensor limited = size;
  for (const int k : found->second) {
    limited = limited_by(segments_[static_cast<std::size_t>(k)], limited, at);
  }
  return limited;
}

// --- points ---

void LatticeSpace::lower_around(const ControlNode& point) {
  const Metric metric = metric_from_size(point.form, point.size);
  while (!divide_cell(point.uv, metric, kUnitsAroundPoint).empty()) {
  }
  for (const int node : support(point.uv, -1).nodes) {
    if (node >= 0) set_size(node, minimum(size(node), point.size));
  }
}

std::vector<int> LatticeSpace::hold_points(const std::vector<ControlNode>& points) {
  std::vector<int> nodes;
  for (const ControlNode& point : points) {
    if (domain_.clamp(point.uv) != point.uv) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("a control node at (u,v) = ({}, {}) lies outside the domain",
                              point.uv.u, point.uv.v));
    }
    if (options().grade > 0) {
      nodes.push_back(add_row_node(point, -1));
    } else {
      lower_around(point);
    }
  }
  return nodes;
}

void LatticeSpace::join_row_nodes(std::vector<int> nodes) {
  if (nodes.size() > kMostJoined) return;
  std::sort(nodes.begin(), nodes.end(), [this](int a, int b) { return uv(a).u < uv(b).u; });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Metric metric = metric_from_size(form(nodes[i]), size(nodes[i]));
    for (std::size_t k = i + 1; k < nodes.size(); ++k) {
      const Uv step = uv(nodes[k]) - uv(nodes[i]);
      // By the least length of any step that goes so far along u.
      const double least = step.u * step.u * determinant(metric) / metric.m22;
      if (!(least < kLongestJoint * kLongestJoint)) break;
      if (squared_length(metric, step) < kLongestJoint * kLongestJoint) {
        segments_.push_back({nodes[i], nodes[k]});
      }
    }
  }
}

// --- sizes ---

SizeTensor LatticeSpace::weighted(const Support& support) const {
  const bool is_logarithmic = !logarithms_.empty();
  const std::vector<SizeTensor>& values =
      is_logarithmic ? logarithms_ : mesh_.property(size_).data_vector();
  // Differences from the first node: exact where all are equal.
  const SizeTensor& first = values[static_cast<std::size_t>(support.nodes[0])];
  SizeTensor sum = first;
  for (std::size_t k = 1; k < support.nodes.size(); ++k) {
    if (support.nodes[k] < 0) continue;
    const SizeTensor& other = values[static_cast<std::size_t>(support.nodes[k])];
    const double weight = support.weights[k];
    sum.h11 += weight * (other.h11 - first.h11);
    sum.h12 += weight * (other.h12 - first.h12);
    sum.h22 += weight * (other.h22 - first.h22);
  }
  return is_logarithmic ? exp_size(sum) : sum;
}

SizeTensor LatticeSpace::lattice_size(Uv uv, int& near) const {
  const Support around = support(uv, near);
  near = around.cell;
  return weighted(around);
}

SizeTensor LatticeSpace::interpolate(const SurfacePoint& at, QueryHint& hint) const {
  ++hint.answers.lattice;
  const SizeTensor size = lattice_size(at.uv, hint.element);
  return segments_of_.empty() ? size : limited_by_rows(size, at, hint.element);
}

std::vector<int> LatticeSpace::with_neighbours(const std::vector<int>& nodes) const {
  std::vector<int> all = nodes;
  for (const int node : nodes) {
    for_each_neighbour(node, [&all](int other) { all.push_back(other); });
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void LatticeSpace::grade(const std::vector<int>& from, const RunContext& context) {
  if (!segments_.empty()) link_rows();
  Gradation gradation(*this, options().grade);
  for (const int node : from) gradation.start_from(node);
  // Cells at rows may have new nodes.
  for (const RowSegment& segment : segments_) gradation.start_from(segment.to);
  gradation.run(context);
}

void LatticeSpace::grade_all(const RunContext& context) {
  grade(nodes_from(0), context);
  for (auto added = divide_beside_finer(); !added.empty(); added = divide_beside_finer()) {
    grade(with_neighbours(added), context);
  }
}

void LatticeSpace::take_logarithms() {
  for (int node = 0; node < node_count(); ++node) logarithms_.push_back(log_size(size(node)));
}

void LatticeSpace::finish() {
  if (options().blend == Blend::Logarithmic) take_logarithms();
  assign_rows();
  std::vector<MetricCorner> metrics;
  metrics.reserve(forms_.size());
  for (int node = 0; node < node_count(); ++node) {
    if (!is_regular(form(node))) continue;  // a pole has no metric
    metrics.push_back({uv(node), metric_from_size(form(node), size(node))});
  }
  store_node_metrics(std::move(metrics));
  build_faces(mesh_, mesh_.n_vertices(), faces(), FirstSide::FromFirstCorner);
  attach(mesh_, keys::face_class, static_cast<int>(Interpolation::Linear));
  attach(mesh_, keys::vertex_radius, 0.0);
  attach(mesh_, keys::vertex_outer_radius, 0.0);
}

}  // namespace surfmesh
