// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/loop_checks.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace surfmesh {
namespace {

constexpr int kSamples = 64;

/// A point may be outside of the domain by this share of its width: formulas round.
constexpr double kOutside = 1e-9;

/// Parts of segments that seem to cross, and how often these are divided: chords of a 262144th of
/// a curve cross only where the curve does.
constexpr int kParts = 8;
constexpr int kMaxDivisions = 4;

/// Parts of one loop are near to each other only if the way along it is more than so many gaps.
constexpr double kLeastWay = 6;

/// A curve is nearer to its chord than this share of the chord's length, but at sharp bends.
constexpr double kBulge = 0.2;

/// A part of a curve and its chord.
struct Segment {
  std::size_t loop = 0;
  std::size_t position = 0;  ///< number of the segment in its loop
  const LoopCurve* curve = nullptr;
  double s0 = 0;
  double s1 = 1;
  Uv a;
  Uv b;
};

std::vector<Segment> segments_of(const LoopCurve& curve, double s0, double s1, int count) {
  std::vector<Segment> result;
  Uv a = curve.at(s0);
  for (int i = 1; i <= count; ++i) {
    const double from = s0 + (s1 - s0) * (i - 1) / count;
    const double to = i == count ? s1 : s0 + (s1 - s0) * i / count;
    const Uv b = curve.at(to);
    result.push_back({0, 0, &curve, from, to, a, b});
    a = b;
  }
  return result;
}

std::vector<Segment> segments_of(const LoopCurves& loop) {
  std::vector<Segment> result;
  for (const LoopCurve& curve : loop) {
    const std::vector<Segment> part = segments_of(curve, 0, 1, kSamples);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

/// True if the chords have a point in common that is an end of neither.
bool is_crossing(const Segment& p, const Segment& q) {
  const double a = cross(p.b - p.a, q.a - p.a), b = cross(p.b - p.a, q.b - p.a);
  const double c = cross(q.b - q.a, p.a - q.a), d = cross(q.b - q.a, p.b - q.a);
  return ((a < 0 && b > 0) || (a > 0 && b < 0)) && ((c < 0 && d > 0) || (c > 0 && d < 0));
}

/// The part of p that crosses q when both are divided again and again, or nothing.
std::optional<Segment> true_crossing(const Segment& p, const Segment& q, int divisions) {
  if (!is_crossing(p, q)) return std::nullopt;
  if (divisions == 0) return p;
  const std::vector<Segment> others = segments_of(*q.curve, q.s0, q.s1, kParts);
  for (const Segment& part : segments_of(*p.curve, p.s0, p.s1, kParts)) {
    for (const Segment& other : others) {
      if (const auto found = true_crossing(part, other, divisions - 1)) return found;
    }
  }
  return std::nullopt;
}

/// True if the segments are at most `reach` segments apart in the same loop of `count`.
bool are_neighbours(const Segment& p, const Segment& q, std::size_t count, std::size_t reach = 1) {
  if (p.loop != q.loop) return false;
  const std::size_t step =
      p.position > q.position ? p.position - q.position : q.position - p.position;
  return step <= reach || step + reach >= count;
}

std::vector<Segment> all_segments(const std::vector<LoopCurves>& loops) {
  std::vector<Segment> result;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::vector<Segment> part = segments_of(loops[l]);
    for (std::size_t i = 0; i < part.size(); ++i) {
      part[i].loop = l;
      part[i].position = i;
    }
    result.insert(result.end(), part.begin(), part.end());
  }
  std::stable_sort(result.begin(), result.end(), [](const Segment& p, const Segment& q) {
    return std::min(p.a.u, p.b.u) < std::min(q.a.u, q.b.u);
  });
  return result;
}

/// Lengths in units of the extent of all loops in u and in v.
class Scale {
 public:
  explicit Scale(const std::vector<Segment>& segments) {
    for (const Segment& s : segments) {
      low_ = {std::min(low_.u, s.a.u), std::min(low_.v, s.a.v)};
      high_ = {std::max(high_.u, s.a.u), std::max(high_.v, s.a.v)};
    }
  }

  double width() const { return high_.u - low_.u; }
  Uv unit(Uv step) const { return {step.u / width(), step.v / (high_.v - low_.v)}; }
  double length(Uv step) const { return std::hypot(unit(step).u, unit(step).v); }
  double length(const Segment& s) const { return length(s.b - s.a); }

  /// True if all of p has a v that is larger than all of q's by more than `reach`.
  bool is_above(const Segment& p, const Segment& q, double reach) const {
    return std::min(p.a.v, p.b.v) > std::max(q.a.v, q.b.v) + reach * (high_.v - low_.v);
  }

  /// The point of a chord that is nearest to p.
  Uv foot(Uv p, const Segment& s) const {
    const Uv chord = unit(s.b - s.a), step = unit(p - s.a);
    const double square = chord.u * chord.u + chord.v * chord.v;
    const double share = square > 0 ? (step.u * chord.u + step.v * chord.v) / square : 0;
    return lerp(s.a, s.b, std::clamp(share, 0.0, 1.0));
  }

  /// The nearest points of two chords that do not cross.
  std::pair<Uv, Uv> nearest(const Segment& p, const Segment& q) const {
    const std::pair<Uv, Uv> candidates[] = {
        {p.a, foot(p.a, q)}, {p.b, foot(p.b, q)}, {foot(q.a, p), q.a}, {foot(q.b, p), q.b}};
    return *std::min_element(std::begin(candidates), std::end(candidates),
                             [this](const auto& x, const auto& y) {
                               return length(x.second - x.first) < length(y.second - y.first);
                             });
  }

  /// Distance of two chords.
  double distance(const Segment& p, const Segment& q) const {
    if (is_crossing(p, q)) return 0;
    const auto [a, b] = nearest(p, q);
    return length(b - a);
  }

 private:
  Uv low_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Uv high_{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

/// Ways along loops, in the lengths of a scale.
class LoopWays {
 public:
  LoopWays(const std::vector<LoopCurves>& loops, const Scale& scale) {
    for (const LoopCurves& loop : loops) {
      std::vector<double>& ways = ways_.emplace_back(1, 0.0);
      for (const Segment& s : segments_of(loop)) ways.push_back(ways.back() + scale.length(s));
    }
  }

  /// The shorter way between parts of two segments of one loop; infinite between loops.
  double between(const Segment& p, const Segment& part_p, const Segment& q,
                 const Segment& part_q) const {
    if (p.loop != q.loop) return std::numeric_limits<double>::infinity();
    const double way = std::abs(middle(p, part_p) - middle(q, part_q));
    return std::min(way, ways_[p.loop].back() - way);
  }

 private:
  double middle(const Segment& whole, const Segment& part) const {
    const double share = (0.5 * (part.s0 + part.s1) - whole.s0) / (whole.s1 - whole.s0);
    const std::vector<double>& ways = ways_[whole.loop];
    return (1 - share) * ways[whole.position] + share * ways[whole.position + 1];
  }

  std::vector<std::vector<double>> ways_;  ///< by loop, to the start of each segment
};

using SegmentPair = std::pair<Segment, Segment>;

/// Divide two segments; the two parts that are nearest to each other.
SegmentPair nearest_parts(const Scale& scale, const Segment& p, const Segment& q) {
  const std::vector<Segment> parts = segments_of(*p.curve, p.s0, p.s1, kParts);
  const std::vector<Segment> others = segments_of(*q.curve, q.s0, q.s1, kParts);
  SegmentPair nearest(parts.front(), others.front());
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& part : parts) {
    for (const Segment& other : others) {
      const double distance = scale.distance(part, other);
      if (!(distance < least)) continue;
      least = distance;
      nearest = {part, other};
    }
  }
  return nearest;
}

/// The nearest parts of two segments after some divisions, if they are nearer than `share`.
std::optional<SegmentPair> near_pair(const Scale& scale, const Segment& p, const Segment& q,
                                     double share) {
  SegmentPair pair(p, q);
  for (int divisions = 0;; ++divisions) {
    const double bulge = kBulge * (scale.length(pair.first) + scale.length(pair.second));
    // Also where curves are not finite or have no extent.
    if (!(scale.distance(pair.first, pair.second) <= share + bulge)) return std::nullopt;
    if (divisions == kMaxDivisions) return pair;
    pair = nearest_parts(scale, pair.first, pair.second);
  }
}

/// True if a segment meets the ray from a point in the direction of growing u an odd number of
/// times. Where the point is so near that it may lie between the curve and its chord, the parts of
/// the segment are asked.
bool meets_ray(const Scale& scale, const Segment& segment, Uv point, int divisions) {
  const double distance = scale.length(scale.foot(point, segment) - point);
  if (divisions > 0 && distance < kBulge * scale.length(segment)) {
    std::vector<Segment> parts = segments_of(*segment.curve, segment.s0, segment.s1, kParts);
    parts.front().a = segment.a;
    parts.back().b = segment.b;
    bool result = false;
    for (const Segment& part : parts) {
      if (meets_ray(scale, part, point, divisions - 1)) result = !result;
    }
    return result;
  }
  const Uv a = segment.a, b = segment.b;
  return (a.v > point.v) != (b.v > point.v) &&
         point.u < a.u + (point.v - a.v) / (b.v - a.v) * (b.u - a.u);
}

}  // namespace

double signed_area(const LoopCurves& loop) {
  double area = 0;
  const Uv origin = loop.front().at(0);
  for (const Segment& segment : segments_of(loop)) {
    area += cross(segment.a - origin, segment.b - origin);
  }
  return area;
}

std::optional<std::string> find_point_outside(const LoopCurves& loop, const Domain& domain) {
  const double du = kOutside * (domain.u1 - domain.u0), dv = kOutside * (domain.v1 - domain.v0);
  for (const Segment& segment : segments_of(loop)) {
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
  const std::vector<Segment> segments = all_segments(loops);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& p = segments[i];
    const double right = std::max(p.a.u, p.b.u);
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const Segment& q = segments[j];
      if (std::min(q.a.u, q.b.u) > right) break;
      if (are_neighbours(p, q, kSamples * loops[p.loop].size())) continue;
      const std::optional<Segment> found = true_crossing(p, q, kMaxDivisions);
      if (!found) continue;
      return fmt::format("contours {} and {} at (u,v) = ({:.6g}, {:.6g})", p.curve->name,
                         q.curve->name, found->a.u, found->a.v);
    }
  }
  return std::nullopt;
}

std::vector<NearParts> near_parts(const std::vector<LoopCurves>& loops, double share) {
  const std::vector<Segment> segments = all_segments(loops);
  const Scale scale(segments);
  const LoopWays ways(loops, scale);
  double longest = 0;
  for (const Segment& s : segments) longest = std::max(longest, scale.length(s));
  using CurveNumber = std::pair<std::size_t, std::size_t>;  // loop, place in the loop
  std::map<std::pair<CurveNumber, CurveNumber>, std::pair<double, NearParts>> nearest;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& p = segments[i];
    const double reach = share + kBulge * (scale.length(p) + longest);
    const double right = std::max(p.a.u, p.b.u) + reach * scale.width();
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const Segment& q = segments[j];
      if (std::min(q.a.u, q.b.u) > right) break;
      if (scale.is_above(p, q, reach) || scale.is_above(q, p, reach)) continue;
      if (are_neighbours(p, q, kSamples * loops[p.loop].size(), kSamples / 4)) continue;
      const auto pair = near_pair(scale, p, q, share);
      if (!pair) continue;
      const double gap = scale.distance(pair->first, pair->second);
      if (ways.between(p, pair->first, q, pair->second) <= kLeastWay * gap) continue;
      const auto [at_p, at_q] = scale.nearest(pair->first, pair->second);
      const NearParts parts{p.curve->name, q.curve->name, at_p, at_q};
      const CurveNumber a(p.loop, p.position / kSamples), b(q.loop, q.position / kSamples);
      const std::pair key(std::min(a, b), std::max(a, b));
      const auto [entry, is_new] = nearest.try_emplace(key, gap, parts);
      if (!is_new && gap < entry->second.first) entry->second = {gap, parts};
    }
  }
  std::vector<NearParts> result;
  for (const auto& [curves, found] : nearest) result.push_back(found.second);
  return result;
}

bool is_inside(const LoopCurves& loop, Uv point) {
  std::vector<Segment> segments = segments_of(loop);
  // Curves meet up to rounding only: a ray must not pass between their ends.
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i].a = segments[i == 0 ? segments.size() - 1 : i - 1].b;
  }
  const Scale scale(segments);
  bool result = false;
  for (const Segment& segment : segments) {
    if (meets_ray(scale, segment, point, kMaxDivisions)) result = !result;
  }
  return result;
}

}  // namespace surfmesh
