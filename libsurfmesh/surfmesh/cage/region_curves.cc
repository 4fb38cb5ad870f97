// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/region_curves.hh"

#include <algorithm>

namespace surfmesh {
namespace {

/// The part of `count` equal ones that t lies in, and the share of it.
struct PartOf {
  PartOf(double t, std::size_t count) {
    const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(count);
    part = std::min(static_cast<std::size_t>(at), count - 1);
    share = at - static_cast<double>(part);
  }

  std::size_t part;
  double share;
};

}  // namespace

Uv SidesInChart::evaluate(double t) const {
  const PartOf at(t, sides_.size());
  const FaceSide& side = sides_[at.part];
  const Uv uv = lerp(side.from, side.to, at.share);
  return frame_.project(side.surface->evaluate(uv, Order::Position).point);
}

/// Beyond the ends points are mirrored, so that the spline begins and ends at control points.
Uv UniformSpline::control_point(int i) const {
  const int last = static_cast<int>(points_.size()) - 1;
  const auto point = [&](int k) { return points_[static_cast<std::size_t>(k)]; };
  if (i < 0) return 2 * point(0) - point(1);
  if (i > last) return 2 * point(last) - point(last - 1);
  return point(i);
}

Uv UniformSpline::evaluate(double t) const {
  if (t <= 0) return points_.front();
  if (t >= 1) return points_.back();
  const PartOf at(t, points_.size() - 1);
  const int first = static_cast<int>(at.part) - 1;
  const double s = at.share, r = 1 - s;
  return (r * r * r / 6) * control_point(first) +
         ((3 * s * s * s - 6 * s * s + 4) / 6) * control_point(first + 1) +
         ((3 * r * r * r - 6 * r * r + 4) / 6) * control_point(first + 2) +
         (s * s * s / 6) * control_point(first + 3);
}

Uv CurveOfOtherChart::evaluate(double t) const {
  return frame_.project(other_->evaluate(curve_->evaluate(t), Order::Position).point);
}

std::vector<Uv> smoothed(std::vector<Uv> points, int times) {
  for (int time = 0; time < times; ++time) {
    Uv before = points.front();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Uv here = points[i];
      points[i] = 0.25 * (before + 2 * here + points[i + 1]);
      before = here;
    }
  }
  return points;
}

}  // namespace surfmesh
