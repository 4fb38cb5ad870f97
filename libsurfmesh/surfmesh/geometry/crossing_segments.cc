// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/crossing_segments.hh"

#include <algorithm>
#include <limits>

#include "surfmesh/geometry/predicates.hh"

namespace surfmesh::detail {
namespace {

/// The direction of the sweep, in shares of the extents: along neither axis, so that the segments
/// of a straight side come one after the other.
constexpr double kAlongU = 0.83, kAlongV = 0.56;

struct Segment {
  LoopSegment name;
  Uv a, b;
  double from, to;  ///< along the sweep
};

/// Measures along the sweep.
class Sweep {
 public:
  explicit Sweep(const std::vector<NodeLoop>& loops) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Uv low{infinity, infinity}, high{-infinity, -infinity};
    for (const NodeLoop& loop : loops) {
      for (const Uv uv : loop) {
        low = {std::min(low.u, uv.u), std::min(low.v, uv.v)};
        high = {std::max(high.u, uv.u), std::max(high.v, uv.v)};
      }
    }
    along_ = {kAlongU / (high.u - low.u), kAlongV / (high.v - low.v)};
  }

  double operator()(Uv uv) const { return along_.u * uv.u + along_.v * uv.v; }

 private:
  Uv along_;
};

std::vector<Segment> sorted_segments(const std::vector<NodeLoop>& loops) {
  const Sweep sweep(loops);
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const Uv a = loops[l][i], b = loops[l][(i + 1) % loops[l].size()];
      const auto [from, to] = std::minmax({sweep(a), sweep(b)});
      segments.push_back({{l, i}, a, b, from, to});
    }
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& p, const Segment& q) { return p.from < q.from; });
  return segments;
}

bool are_neighbours(const LoopSegment& p, const LoopSegment& q, std::size_t count) {
  if (p.loop != q.loop) return false;
  return (p.node + 1) % count == q.node || (q.node + 1) % count == p.node;
}

bool do_boxes_meet(const Segment& p, const Segment& q) {
  return std::max(p.a.u, p.b.u) >= std::min(q.a.u, q.b.u) &&
         std::max(q.a.u, q.b.u) >= std::min(p.a.u, p.b.u) &&
         std::max(p.a.v, p.b.v) >= std::min(q.a.v, q.b.v) &&
         std::max(q.a.v, q.b.v) >= std::min(p.a.v, p.b.v);
}

/// True if the segments have an end in common, and nothing else.
bool do_touch_in_ends(const Segment& p, const Segment& q) {
  const bool is_from_a = p.a == q.a || p.a == q.b, is_from_b = p.b == q.a || p.b == q.b;
  if (is_from_a == is_from_b) return false;
  const Uv common = is_from_a ? p.a : p.b, end_p = is_from_a ? p.b : p.a;
  const Uv end_q = q.a == common ? q.b : q.a;
  if (orient2d(common, end_p, end_q) != 0) return true;
  const Uv to_p = end_p - common, to_q = end_q - common;
  return to_p.u * to_q.u + to_p.v * to_q.v < 0;
}

bool is_crossing(const Segment& p, const Segment& q) {
  if (do_touch_in_ends(p, q)) return false;
  return do_boxes_meet(p, q) && orient2d(p.a, p.b, q.a) * orient2d(p.a, p.b, q.b) <= 0 &&
         orient2d(q.a, q.b, p.a) * orient2d(q.a, q.b, p.b) <= 0;
}

}  // namespace

std::vector<std::pair<LoopSegment, LoopSegment>> crossing_segments(
    const std::vector<NodeLoop>& loops) {
  const std::vector<Segment> segments = sorted_segments(loops);
  std::vector<std::pair<LoopSegment, LoopSegment>> result;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& p = segments[i];
    for (std::size_t j = i + 1; j < segments.size() && segments[j].from <= p.to; ++j) {
      const Segment& q = segments[j];
      if (are_neighbours(p.name, q.name, loops[p.name.loop].size())) continue;
      if (is_crossing(p, q)) result.emplace_back(p.name, q.name);
    }
  }
  return result;
}

}  // namespace surfmesh::detail
