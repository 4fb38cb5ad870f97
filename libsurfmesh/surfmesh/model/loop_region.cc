// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/loop_region.hh"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surfmesh {
namespace {

/// Parts of a segment that is near a point, and how often these are divided.
constexpr int kRegionParts = 8;
constexpr int kMaxRegionDivisions = 4;

/// Curves meet up to rounding only: a ray must not pass between their ends.
std::vector<LoopSegment> closed_segments(const LoopCurves& loop) {
  std::vector<LoopSegment> segments = segments_of(loop);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i].a = segments[i == 0 ? segments.size() - 1 : i - 1].b;
  }
  return segments;
}

std::vector<BoxTree::Box> boxes_of(const std::vector<LoopRegion>& regions) {
  std::vector<BoxTree::Box> boxes;
  for (const LoopRegion& region : regions) boxes.push_back(region.box());
  return boxes;
}

/// A box of (u,v), larger by a share of its width and height.
BoxTree::Box enlarged(Uv low, Uv high, double share) {
  const Uv margin = share * (high - low);
  return plane_box(low - margin, high + margin);
}

}  // namespace

LoopRegion::LoopRegion(const LoopCurves& loop)
    : segments_(closed_segments(loop)), scale_(segments_), tree_(boxes()) {
  Uv low = segments_.front().low(), high = segments_.front().high();
  for (const LoopSegment& s : segments_) {
    low = {std::min(low.u, s.low().u), std::min(low.v, s.low().v)};
    high = {std::max(high.u, s.high().u), std::max(high.v, s.high().v)};
  }
  box_ = enlarged(low, high, kBulge * std::sqrt(2.0));  // no chord is longer than √2 in the scale
}

std::vector<BoxTree::Box> LoopRegion::boxes() const {
  std::vector<BoxTree::Box> result;
  for (const LoopSegment& s : segments_) {
    result.push_back(scale_.box_around(s, kBulge * scale_.length(s)));
  }
  return result;
}

bool LoopRegion::contains(Uv point) const {
  const Uv at = scale_.place(point);
  const BoxTree::Box ray = plane_box(at, {std::numeric_limits<double>::infinity(), at.v});
  bool result = false;
  tree_.visit(ray, [&](std::size_t i) {
    if (meets_ray(segments_[i], point, kMaxRegionDivisions)) result = !result;
  });
  return result;
}

/// True if a segment meets the ray from a point in the direction of growing u an odd number of
/// times. Where the point is so near that it may lie between the curve and its chord, the parts of
/// the segment are asked.
bool LoopRegion::meets_ray(const LoopSegment& segment, Uv point, int divisions) const {
  const double distance = scale_.length(scale_.foot(point, segment) - point);
  if (divisions > 0 && distance < kBulge * scale_.length(segment)) {
    std::vector<LoopSegment> parts =
        segments_of(*segment.curve, segment.s0, segment.s1, kRegionParts);
    parts.front().a = segment.a;
    parts.back().b = segment.b;
    bool result = false;
    for (const LoopSegment& part : parts) {
      if (meets_ray(part, point, divisions - 1)) result = !result;
    }
    return result;
  }
  const Uv a = segment.a, b = segment.b;
  return (a.v > point.v) != (b.v > point.v) &&
         point.u < a.u + (point.v - a.v) / (b.v - a.v) * (b.u - a.u);
}

LoopRegions::LoopRegions(const std::vector<LoopCurves>& loops)
    : regions_(loops.begin(), loops.end()), tree_(boxes_of(regions_)) {}

std::vector<std::size_t> LoopRegions::around(Uv point) const {
  std::vector<std::size_t> result = tree_.meeting(plane_box(point, point));
  std::erase_if(result, [&](std::size_t loop) { return !regions_[loop].contains(point); });
  return result;
}

}  // namespace surfmesh
