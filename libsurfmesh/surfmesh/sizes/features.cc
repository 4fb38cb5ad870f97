// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/features.hh"

#include "surfmesh/geometry/curve_polyline.hh"

namespace surfmesh {
namespace {

/// Share of the contour's length within which the size holds where there is no gradation.
constexpr double kFeatureHalo = 0.5;

/// Distance of chords from the contour as a share of hmax: where that is too coarse to see a bend,
/// the contour is far shorter than hmax anyway.
constexpr double kFeatureChordShare = 0.01;

}  // namespace

std::vector<PlacedSize> feature_sizes(const SpaceCurve& curve, const ResolvedSizing& sizing) {
  const auto points = curve_polyline(curve, kFeatureChordShare * sizing.bounds.hmax);
  const double whole = length(points);
  if (!(whole < sizing.bounds.hmax) || whole == 0) return {};
  PlacedSize placed;
  const double size = sizing.bounds.clamp(whole);
  placed.at_from = placed.at_to = {size, size};
  if (sizing.grade == 0) placed.radius = kFeatureHalo * size;
  std::vector<PlacedSize> sizes;
  for (std::size_t i = 1; i < points.size(); ++i) {
    placed.from = points[i - 1].point;
    placed.to = points[i].point;
    sizes.push_back(placed);
  }
  return sizes;
}

}  // namespace surfmesh
