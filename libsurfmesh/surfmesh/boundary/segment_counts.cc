// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/segment_counts.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "surfmesh/boundary/segment_shape.hh"

namespace surfmesh {
namespace {

/// Numbers of segments that are tried for the sag, as shares of the metric length.
constexpr double kFewest = 0.71, kMost = 4;

/// Segments for each unit of metric length up to which a factor makes more of them: beside more,
/// the triangles would be flat.
constexpr double kMostByFactor = 3;

/// The share of the sag that the samples of a segment may have: the greatest lies between them.
constexpr double kSagShare = 0.95;

/// True if none of so many segments is farther from the surface than the sag.
bool holds(const Surface& surface, const Curve& curve, const MetricArc& arc, int count,
           double sag) {
  double from = 0;
  for (int i = 1; i <= count; ++i) {
    const double to = i == count ? 1.0 : arc.parameter(i * arc.length() / count);
    if (segment_sag(surface, curve, from, to) > kSagShare * sag) return false;
    from = to;
  }
  return true;
}

}  // namespace

LeastSegments::LeastSegments(const Model& model) : is_pole_(model.vertices.size(), false) {
  for (const Contour& contour : model.contours) {
    if (contour.is_degenerate) {
      is_pole_[static_cast<std::size_t>(contour.start)] = true;
    } else {
      ++count_[std::minmax(contour.start, contour.end)];
    }
  }
}

int LeastSegments::operator()(const Contour& contour) const {
  const bool starts_at_pole = is_pole_[static_cast<std::size_t>(contour.start)];
  const bool ends_at_pole = is_pole_[static_cast<std::size_t>(contour.end)];
  const bool is_closed = contour.start == contour.end;
  const bool is_alone = count_.at(std::minmax(contour.start, contour.end)) == 1;
  const int least = is_closed ? 3 : is_alone ? 1 : 2;
  return std::max(least, 1 + (starts_at_pole ? 1 : 0) + (ends_at_pole ? 1 : 0));
}

int rounded_up(int count, int multiple) { return (count + multiple - 1) / multiple * multiple; }

int segments_for_sag(const Surface& surface, const Curve& curve, const MetricArc& arc,
                     const SegmentBounds& bounds) {
  const int step = bounds.multiple;
  const double length = arc.length();
  int count = std::max(bounds.least, step * static_cast<int>(std::ceil(kFewest * length / step)));
  while (count < kMost * length && !holds(surface, curve, arc, count, bounds.sag)) count += step;
  const double more = std::min(bounds.factor * count, kMostByFactor * length);
  return std::max(count, rounded_up(static_cast<int>(std::lround(more)), step));
}

}  // namespace surfmesh
