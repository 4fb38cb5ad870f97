// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/model/loop_checks.hh"

/// Loops in segments, as their checks see them.
namespace surfmesh {

/// Segments of each curve of a loop.
inline constexpr int kLoopSamples = 64;

/// A curve is nearer to its chord than this share of the chord's length, but at sharp bends.
inline constexpr double kBulge = 0.2;

/// A part of a curve and its chord.
struct LoopSegment {
  std::size_t loop = 0;
  std::size_t position = 0;  ///< number of the segment in its loop
  const LoopCurve* curve = nullptr;
  double s0 = 0;
  double s1 = 1;
  Uv a;
  Uv b;

  Uv low() const { return {std::min(a.u, b.u), std::min(a.v, b.v)}; }
  Uv high() const { return {std::max(a.u, b.u), std::max(a.v, b.v)}; }
};

/// A part of a curve in so many segments.
std::vector<LoopSegment> segments_of(const LoopCurve& curve, double s0, double s1, int count);

/// The curves of a loop, which must outlive its segments.
std::vector<LoopSegment> segments_of(const LoopCurves& loop);

/// True if the chords have a point in common that is an end of neither.
bool is_crossing(const LoopSegment& p, const LoopSegment& q);

/// Lengths in units of the extent of all loops in u and in v.
class LoopScale {
 public:
  explicit LoopScale(const std::vector<LoopSegment>& segments);

  Uv unit(Uv step) const { return {step.u / (high_.u - low_.u), step.v / (high_.v - low_.v)}; }
  double length(Uv step) const;
  double length(const LoopSegment& s) const { return length(s.b - s.a); }

  /// The box of a chord, larger by a length on all sides, in units from the least u and v.
  BoxTree::Box box_around(const LoopSegment& s, double length) const;

  /// A point in these units.
  Uv place(Uv p) const { return unit(p - low_); }

  /// The point of a chord that is nearest to p.
  Uv foot(Uv p, const LoopSegment& s) const;

  /// The nearest points of two chords that do not cross.
  std::pair<Uv, Uv> nearest(const LoopSegment& p, const LoopSegment& q) const;

  /// Distance of two chords.
  double distance(const LoopSegment& p, const LoopSegment& q) const;

 private:
  Uv low_, high_;
};

}  // namespace surfmesh
