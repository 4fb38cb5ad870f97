// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/loop_checks.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/model/loop_segments.hh"

namespace surfmesh {
namespace {

/// A point may be outside of the domain by this share of its width: formulas round.
constexpr double kOutside = 1e-9;

/// Parts of segments that seem to cross, and how often these are divided: chords of a 262144th of
/// a curve cross only where the curve does.
constexpr int kParts = 8;
constexpr int kMaxDivisions = 4;

/// Parts of one loop are near to each other only if the way along it is more than so many gaps.
constexpr double kLeastWay = 6;

/// The part of p that crosses q when both are divided again and again, or nothing.
std::optional<LoopSegment> true_crossing(const LoopSegment& p, const LoopSegment& q,
                                         int divisions) {
  if (!is_crossing(p, q)) return std::nullopt;
  if (divisions == 0) return p;
  const std::vector<LoopSegment> others = segments_of(*q.curve, q.s0, q.s1, kParts);
  for (const LoopSegment& part : segments_of(*p.curve, p.s0, p.s1, kParts)) {
    for (const LoopSegment& other : others) {
      if (const auto found = true_crossing(part, other, divisions - 1)) return found;
    }
  }
  return std::nullopt;
}

/// True if the segments are at most `reach` segments apart in the same loop of `count`.
bool are_neighbours(const LoopSegment& p, const LoopSegment& q, std::size_t count,
                    std::size_t reach = 1) {
  if (p.loop != q.loop) return false;
  const std::size_t step =
      p.position > q.position ? p.position - q.position : q.position - p.position;
  return step <= reach || step + reach >= count;
}

std::vector<LoopSegment> all_segments(const std::vector<LoopCurves>& loops) {
  std::vector<LoopSegment> result;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<LoopSegment> part = segments_of(loops[l]);
    for (std::size_t i = 0; i < part.size(); ++i) {
      part[i].loop = l;
      part[i].position = i;
    }
    result.insert(result.end(), part.begin(), part.end());
  }
  std::stable_sort(result.begin(), result.end(), [](const LoopSegment& p, const LoopSegment& q) {
    return std::min(p.a.u, p.b.u) < std::min(q.a.u, q.b.u);
  });
  return result;
}

/// Finds the segments whose boxes meet when each is larger by a reach of its own.
class MeetingSegments {
 public:
  /// Units    reach(segment) as lengths in the scale
  template <class Reach>
  MeetingSegments(const LoopScale& scale, const std::vector<LoopSegment>& segments, Reach reach)
      : boxes_(boxes(scale, segments, reach)), tree_(boxes_) {}

  /// Those behind one of the segments, in their order.
  std::vector<std::size_t> after(std::size_t i) const {
    std::vector<std::size_t> result;
    tree_.visit(boxes_[i], [&](std::size_t j) {
      if (j > i) result.push_back(j);
    });
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  template <class Reach>
  static std::vector<BoxTree::Box> boxes(const LoopScale& scale,
                                         const std::vector<LoopSegment>& segments, Reach reach) {
    std::vector<BoxTree::Box> result;
    for (const LoopSegment& s : segments) result.push_back(scale.box_around(s, reach(s)));
    return result;
  }

  std::vector<BoxTree::Box> boxes_;
  BoxTree tree_;
};

/// Ways along loops, in the lengths of a scale.
class LoopWays {
 public:
  LoopWays(const std::vector<LoopCurves>& loops, const LoopScale& scale) {
    for (const LoopCurves& loop : loops) {
      std::vector<double>& ways = ways_.emplace_back(1, 0.0);
      for (const LoopSegment& s : segments_of(loop)) ways.push_back(ways.back() + scale.length(s));
    }
  }

  /// No less than the shorter way between any parts of two segments of one loop; infinite between
  /// loops.
  double greatest_between(const LoopSegment& p, const LoopSegment& q) const {
    if (p.loop != q.loop) return std::numeric_limits<double>::infinity();
    const std::vector<double>& ways = ways_[p.loop];
    const auto [first, last] = std::minmax(p.position, q.position);
    return std::min(ways[last + 1] - ways[first], ways[first + 1] + ways.back() - ways[last]);
  }

  /// The shorter way between parts of two segments of one loop; infinite between loops.
  double between(const LoopSegment& p, const LoopSegment& part_p, const LoopSegment& q,
                 const LoopSegment& part_q) const {
    if (p.loop != q.loop) return std::numeric_limits<double>::infinity();
    const double way = std::abs(middle(p, part_p) - middle(q, part_q));
    return std::min(way, ways_[p.loop].back() - way);
  }

 private:
  double middle(const LoopSegment& whole, const LoopSegment& part) const {
    const double share = (0.5 * (part.s0 + part.s1) - whole.s0) / (whole.s1 - whole.s0);
    const std::vector<double>& ways = ways_[whole.loop];
    return (1 - share) * ways[whole.position] + share * ways[whole.position + 1];
  }

  std::vector<std::vector<double>> ways_;  ///< by loop, to the start of each segment
};

using SegmentPair = std::pair<LoopSegment, LoopSegment>;

/// Divide two segments; the two parts that are nearest to each other.
SegmentPair nearest_parts(const LoopScale& scale, const LoopSegment& p, const LoopSegment& q) {
  const std::vector<LoopSegment> parts = segments_of(*p.curve, p.s0, p.s1, kParts);
  const std::vector<LoopSegment> others = segments_of(*q.curve, q.s0, q.s1, kParts);
  SegmentPair nearest(parts.front(), others.front());
  double least = std::numeric_limits<double>::infinity();
  for (const LoopSegment& part : parts) {
    for (const LoopSegment& other : others) {
      const double distance = scale.distance(part, other);
      if (!(distance < least)) continue;
      least = distance;
      nearest = {part, other};
    }
  }
  return nearest;
}

/// True if all parts of two segments are as near along their loop as kLeastWay asks, which most
/// neighbours are: it is cheaper than to look for the nearest parts.
bool are_beside(const LoopScale& scale, const LoopWays& ways, const LoopSegment& p,
                const LoopSegment& q) {
  const double bulge = kBulge * (scale.length(p) + scale.length(q));
  return ways.greatest_between(p, q) <= kLeastWay * (scale.distance(p, q) - bulge);
}

/// The nearest parts of two segments after some divisions, if they are nearer than `share`.
std::optional<SegmentPair> near_pair(const LoopScale& scale, const LoopSegment& p,
                                     const LoopSegment& q, double share) {
  SegmentPair pair(p, q);
  for (int divisions = 0;; ++divisions) {
    const double bulge = kBulge * (scale.length(pair.first) + scale.length(pair.second));
    // Also where curves are not finite or have no extent.
    if (!(scale.distance(pair.first, pair.second) <= share + bulge)) return std::nullopt;
    if (divisions == kMaxDivisions) return pair;
    pair = nearest_parts(scale, pair.first, pair.second);
  }
}

}  // namespace

double signed_area(const LoopCurves& loop) {
  double area = 0;
  const Uv origin = loop.front().at(0);
  for (const LoopSegment& segment : segments_of(loop)) {
    area += cross(segment.a - origin, segment.b - origin);
  }
  return area;
}

std::optional<std::string> find_point_outside(const LoopCurves& loop, const Domain& domain) {
  const double du = kOutside * (domain.u1 - domain.u0), dv = kOutside * (domain.v1 - domain.v0);
  for (const LoopSegment& segment : segments_of(loop)) {
    const Uv p = segment.a;
    const bool is_in = p.u >= domain.u0 - du && p.u <= domain.u1 + du && p.v >= domain.v0 - dv &&
                       p.v <= domain.v1 + dv;
    if (is_in) continue;
    const LoopCurve& curve = *segment.curve;
    const double t = curve.range.at(curve.is_along ? segment.s0 : 1 - segment.s0);
    return fmt::format("contour {} at t = {:.6g}, (u,v) = ({:.6g}, {:.6g})", curve.name, t, p.u,
                       p.v);
  }
  return std::nullopt;
}

std::optional<std::string> crossing(const std::vector<LoopCurves>& loops) {
  const std::vector<LoopSegment> segments = all_segments(loops);
  const LoopScale scale(segments);
  const MeetingSegments meeting(scale, segments, [](const LoopSegment&) { return 0.0; });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const LoopSegment& p = segments[i];
    for (const std::size_t j : meeting.after(i)) {
      const LoopSegment& q = segments[j];
      if (are_neighbours(p, q, kLoopSamples * loops[p.loop].size())) continue;
      const std::optional<LoopSegment> found = true_crossing(p, q, kMaxDivisions);
      if (!found) continue;
      return fmt::format("contours {} and {} at (u,v) = ({:.6g}, {:.6g})", p.curve->name,
                         q.curve->name, found->a.u, found->a.v);
    }
  }
  return std::nullopt;
}

std::vector<NearParts> near_parts(const std::vector<LoopCurves>& loops, double share) {
  const std::vector<LoopSegment> segments = all_segments(loops);
  const LoopScale scale(segments);
  const LoopWays ways(loops, scale);
  const MeetingSegments meeting(scale, segments, [&](const LoopSegment& s) {
    return 0.5 * share + kBulge * scale.length(s);
  });
  using CurveNumber = std::pair<std::size_t, std::size_t>;  // loop, place in the loop
  std::map<std::pair<CurveNumber, CurveNumber>, std::pair<double, NearParts>> nearest;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const LoopSegment& p = segments[i];
    for (const std::size_t j : meeting.after(i)) {
      const LoopSegment& q = segments[j];
      if (are_neighbours(p, q, kLoopSamples * loops[p.loop].size(), kLoopSamples / 4)) continue;
      if (are_beside(scale, ways, p, q)) continue;
      const auto pair = near_pair(scale, p, q, share);
      if (!pair) continue;
      const double gap = scale.distance(pair->first, pair->second);
      if (ways.between(p, pair->first, q, pair->second) <= kLeastWay * gap) continue;
      const auto [at_p, at_q] = scale.nearest(pair->first, pair->second);
      const NearParts parts{p.curve->name, q.curve->name, at_p, at_q};
      const CurveNumber a(p.loop, p.position / kLoopSamples), b(q.loop, q.position / kLoopSamples);
      const std::pair key(std::min(a, b), std::max(a, b));
      const auto [entry, is_new] = nearest.try_emplace(key, gap, parts);
      if (!is_new && gap < entry->second.first) entry->second = {gap, parts};
    }
  }
  std::vector<NearParts> result;
  for (const auto& [curves, found] : nearest) result.push_back(found.second);
  return result;
}

}  // namespace surfmesh
