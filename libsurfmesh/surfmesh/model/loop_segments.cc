// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/loop_segments.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace surfmesh {
namespace {

/// Boxes are larger by this share of the extent, so that rounding leaves out nothing that touches.
constexpr double kBoxRounding = 1e-12;

}  // namespace

std::vector<LoopSegment> segments_of(const LoopCurve& curve, double s0, double s1, int count) {
  std::vector<LoopSegment> result;
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

std::vector<LoopSegment> segments_of(const LoopCurves& loop) {
  std::vector<LoopSegment> result;
  for (const LoopCurve& curve : loop) {
    const std::vector<LoopSegment> part = segments_of(curve, 0, 1, kLoopSamples);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

bool is_crossing(const LoopSegment& p, const LoopSegment& q) {
  const double a = cross(p.b - p.a, q.a - p.a), b = cross(p.b - p.a, q.b - p.a);
  const double c = cross(q.b - q.a, p.a - q.a), d = cross(q.b - q.a, p.b - q.a);
  return ((a < 0 && b > 0) || (a > 0 && b < 0)) && ((c < 0 && d > 0) || (c > 0 && d < 0));
}

LoopScale::LoopScale(const std::vector<LoopSegment>& segments) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  low_ = {infinity, infinity};
  high_ = {-infinity, -infinity};
  for (const LoopSegment& s : segments) {
    low_ = {std::min(low_.u, s.a.u), std::min(low_.v, s.a.v)};
    high_ = {std::max(high_.u, s.a.u), std::max(high_.v, s.a.v)};
  }
}

double LoopScale::length(Uv step) const { return std::hypot(unit(step).u, unit(step).v); }

BoxTree::Box LoopScale::box_around(const LoopSegment& s, double length) const {
  const Uv low = place(s.low()), high = place(s.high());
  const double margin = length + kBoxRounding;
  return plane_box({low.u - margin, low.v - margin}, {high.u + margin, high.v + margin});
}

Uv LoopScale::foot(Uv p, const LoopSegment& s) const {
  const Uv chord = unit(s.b - s.a), step = unit(p - s.a);
  const double square = chord.u * chord.u + chord.v * chord.v;
  const double share = square > 0 ? (step.u * chord.u + step.v * chord.v) / square : 0;
  return lerp(s.a, s.b, std::clamp(share, 0.0, 1.0));
}

std::pair<Uv, Uv> LoopScale::nearest(const LoopSegment& p, const LoopSegment& q) const {
  const std::pair<Uv, Uv> candidates[] = {
      {p.a, foot(p.a, q)}, {p.b, foot(p.b, q)}, {foot(q.a, p), q.a}, {foot(q.b, p), q.b}};
  return *std::min_element(std::begin(candidates), std::end(candidates),
                           [this](const auto& x, const auto& y) {
                             return length(x.second - x.first) < length(y.second - y.first);
                           });
}

double LoopScale::distance(const LoopSegment& p, const LoopSegment& q) const {
  if (is_crossing(p, q)) return 0;
  const auto [a, b] = nearest(p, q);
  return length(b - a);
}

}  // namespace surfmesh
