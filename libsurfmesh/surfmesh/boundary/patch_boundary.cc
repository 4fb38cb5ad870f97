// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/patch_boundary.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/boundary/metric_arc.hh"

namespace surfmesh {
namespace {

/// A segment of a loop that lies on a degenerate contour, before it is cut off.
bool is_pole(const Model& model, const BoundaryNode& node) {
  return node.contour >= 0 && model.contour(node.contour).is_degenerate;
}

BoundaryLoop chain_of_nodes(const Model& model, const PatchLoop& loop,
                            const std::vector<ContourNodes>& nodes, const NodeNumbers& numbers) {
  BoundaryLoop chain;
  for (const LoopEntry& entry : loop) {
    const ContourNodes& list = nodes[static_cast<std::size_t>(entry.contour)];
    const auto& uv = list.uv[static_cast<std::size_t>(entry.use)];
    const bool is_forward = model.use(entry).is_forward;
    const int count = list.segment_count();
    for (int i = 0; i < count; ++i) {
      const int node = is_forward ? i : count - i;
      chain.push_back(
          {uv[static_cast<std::size_t>(node)], numbers(entry.contour, node), entry.contour});
    }
  }
  return chain;
}

/// The least number of segments of a ring that joins two nodes. Of two patches at a pole both rings
/// join the same nodes.
int least_segments(const Model& model, int pole, const BoundaryNode& from, const BoundaryNode& to) {
  if (from.vertex == to.vertex) return 3;
  const auto sides = std::count_if(
      model.contours.begin(), model.contours.end(),
      [&](const Contour& contour) { return contour.is_degenerate && contour.start == pole; });
  return sides == 2 ? 2 : 1;
}

/// Nodes between `from` and `to` at equal metric distances along the straight line.
std::vector<Uv> ring_between(const BoundaryNode& from, const BoundaryNode& to, int least,
                             const MetricField& field) {
  const SegmentCurve line(from.uv, to.uv);
  const MetricArc arc(line, field);
  const int count = std::max(least, static_cast<int>(std::lround(arc.length())));
  std::vector<Uv> inner;
  for (int i = 1; i < count; ++i) {
    inner.push_back(line.evaluate(arc.parameter(i * arc.length() / count)));
  }
  return inner;
}

/// Replace each pole in a loop by a ring. `offset` is the number of nodes in earlier loops.
BoundaryLoop cut_off_poles(const Model& model, const BoundaryLoop& chain, int offset,
                           const MetricField& field, std::vector<PoleFan>& fans) {
  BoundaryLoop loop = chain;
  // Start at a node that is no end of a pole, so that none wraps around.
  const std::size_t n = chain.size();
  std::size_t start = 0;
  while (start < n &&
         (is_pole(model, chain[start]) || is_pole(model, chain[(start + n - 1) % n]))) {
    ++start;
  }
  if (start == n) return loop;
  loop.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const BoundaryNode& node = chain[(start + i) % n];
    if (!is_pole(model, node)) {
      loop.push_back(node);
      continue;
    }
    // `loop` ends with the node before the pole; all of the pole's own nodes are skipped.
    std::size_t sides = 1;
    while (is_pole(model, chain[(start + i + sides) % n])) ++sides;
    PoleFan fan;
    fan.pole = node.vertex;
    for (std::size_t k = 0; k <= sides; ++k) fan.sides.push_back(chain[(start + i + k) % n].uv);
    BoundaryNode& before = loop.back();
    const BoundaryNode after = chain[(start + i + sides + 1) % n];
    fan.contour_to = before.contour;
    fan.contour_from = chain[(start + i + sides) % n].contour;
    before.contour = -1;
    fan.ring.push_back(offset + static_cast<int>(loop.size()) - 1);
    const int least = least_segments(model, fan.pole, before, after);
    for (const Uv uv : ring_between(before, after, least, field)) {
      fan.ring.push_back(offset + static_cast<int>(loop.size()));
      loop.push_back({uv, -1, -1});
    }
    const bool wraps = i + sides + 1 >= n;
    fan.ring.push_back(wraps ? offset : offset + static_cast<int>(loop.size()));
    fans.push_back(std::move(fan));
    i += sides;
  }
  return loop;
}

}  // namespace

NodeNumbers::NodeNumbers(const Model& model, const std::vector<ContourNodes>& nodes)
    : count_(static_cast<int>(model.vertices.size())) {
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    const int segments = nodes[c].segment_count();
    ranges_.push_back({model.contours[c].start, model.contours[c].end, count_, segments});
    count_ += std::max(0, segments - 1);
  }
}

int NodeNumbers::operator()(int contour, int node) const {
  const Range& range = ranges_[static_cast<std::size_t>(contour)];
  if (node == 0) return range.start;
  if (node == range.segments) return range.end;
  return range.first_inner + node - 1;
}

Uv point_on_pole(const PoleFan& fan, double share) {
  const double place = share * static_cast<double>(fan.sides.size() - 1);
  const auto side = std::min(static_cast<std::size_t>(place), fan.sides.size() - 2);
  return lerp(fan.sides[side], fan.sides[side + 1], place - static_cast<double>(side));
}

PatchBoundary collect_boundary(const Model& model, int patch,
                               const std::vector<ContourNodes>& nodes, const NodeNumbers& numbers,
                               const MetricField& field) {
  PatchBoundary boundary;
  int offset = 0;
  for (const PatchLoop& loop : model.patch(patch).loops) {
    const BoundaryLoop chain = chain_of_nodes(model, loop, nodes, numbers);
    boundary.loops.push_back(cut_off_poles(model, chain, offset, field, boundary.fans));
    offset += static_cast<int>(boundary.loops.back().size());
  }
  return boundary;
}

}  // namespace surfmesh
