// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/point_nodes.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/sizes/place_sources.hh"
#include "surfmesh/sizes/source_place.hh"

namespace surfmesh {
namespace {

ControlNode node_at(Uv uv, const Surface& surface, const SizeTensor& size) {
  const Jet jet = surface.evaluate(uv, Order::First);
  return {uv, jet.point, first_form_factor(jet.du, jet.dv), size, {}};
}

/// Nodes on a curve so that chords are about as long as the size there; at least the two ends.
void add_curve_nodes(const Curve& curve, const Size& wish, const SizeField& field,
                     std::vector<ControlNode>& nodes) {
  const SizeTensor size = field.bounds().clamp(field.bounds().tensor(wish));
  const double spacing = principal_sizes(size).l_t;
  constexpr int samples = 256;
  const Surface& surface = field.surface();
  const auto add = [&](double t) {
    nodes.push_back(node_at(curve.evaluate(t), surface, size));
    nodes.back().size = field.bounds().clamp(minimum(size, field.at(nodes.back().uv).size));
  };
  double rest = 0;
  add(0);
  Vec3 last = nodes.back().point;
  for (int i = 1; i <= samples; ++i) {
    const double t = double(i) / samples;
    const Vec3 next = surface.evaluate(curve.evaluate(t), Order::Position).point;
    const double step = (next - last).norm();
    const double from = t - 1.0 / samples;
    for (double s = spacing - rest; s < step; s += spacing) add(from + s / step / samples);
    rest = std::fmod(rest + step, spacing);
    last = next;
  }
  add(1);
}

ControlNode node_of(const AtSource& source, const Surface& surface, const SizeBounds& bounds) {
  const SizeTensor size = bounds.clamp(bounds.tensor(source.size));
  ControlNode node = node_at(inside_domain(surface, source.at), surface, size);
  node.radius = bounds.radius(source.radius);
  if (node.radius > 0 || source.outer) node.inner = size;
  if (source.outer) {
    node.outer_radius = bounds.radius(source.outer->radius);
    node.size = node.outer = bounds.clamp(bounds.tensor(source.outer->size));
  }
  return node;
}

}  // namespace

std::vector<ControlNode> point_nodes(const std::vector<AtSource>& sources, const Surface& surface,
                                     const SizeBounds& bounds) {
  std::vector<ControlNode> nodes;
  for (const AtSource& source : sources) {
    nodes.push_back(at_source(source, [&] { return node_of(source, surface, bounds); }));
  }
  return nodes;
}

bool has_other_sources(const PatchSources& sources, const SizeField& field) {
  return field.has_area_source() || !sources.along.empty() || !sources.trees.empty();
}

std::vector<ControlNode> field_nodes(const PatchSources& sources, const SizeField& field,
                                     bool is_graded) {
  const SizeBounds& bounds = field.bounds();
  std::vector<ControlNode> nodes = point_nodes(sources.at, field.surface(), bounds);
  if (has_other_sources(sources, field)) {
    for (ControlNode& node : nodes) {
      // Closed forms are part of the field; without a radius and gradation a node is all there is.
      node.size = bounds.clamp(minimum(node.size, field.at(node.uv).size));
    }
  }
  if (is_graded) return nodes;
  for (const AlongSource& source : sources.along) {
    if (source.wish.radius.value > 0 || source.wish.outer) continue;
    for (const auto& curve : source.curves) {
      add_curve_nodes(*curve, source.wish.size, field, nodes);
    }
  }
  return nodes;
}

}  // namespace surfmesh
