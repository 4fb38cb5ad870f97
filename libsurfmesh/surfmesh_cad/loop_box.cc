// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/loop_box.hh"

#include <algorithm>
#include <cmath>
#include <functional>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh_cad/face_loops.hh"

namespace surfmesh {
namespace {

/// Points along a curve, between which its extremes are searched for.
constexpr int kSamples = 32;

/// Each step of the search leaves 0.618 of the interval; the extreme is quadratic in what is left.
constexpr int kSearchSteps = 22;
const double kGolden = (std::sqrt(5.0) - 1) / 2;

/// The t of the greatest value between two others, which the samples around it are.
double search_greatest(const std::function<double(double)>& value, double from, double to) {
  double a = to - kGolden * (to - from), b = from + kGolden * (to - from);
  double value_a = value(a), value_b = value(b);
  for (int i = 0; i < kSearchSteps; ++i) {
    if (value_a > value_b) {
      to = b, b = a, value_b = value_a;
      a = to - kGolden * (to - from);
      value_a = value(a);
    } else {
      from = a, a = b, value_a = value_b;
      b = from + kGolden * (to - from);
      value_b = value(b);
    }
  }
  return 0.5 * (from + to);
}

/// Extend by where a coordinate is greatest, if that lies between the ends.
void extend_by_greatest(const Curve& curve, const std::function<double(Uv)>& coordinate,
                        const std::vector<Uv>& points, LoopBox& box) {
  const auto greatest = std::max_element(points.begin(), points.end(),
                                         [&](Uv a, Uv b) { return coordinate(a) < coordinate(b); });
  const double at = static_cast<double>(greatest - points.begin());
  if (at == 0 || at == kSamples) return;
  const auto value = [&](double t) { return coordinate(curve.evaluate(t)); };
  box.extend(curve.evaluate(search_greatest(value, (at - 1) / kSamples, (at + 1) / kSamples)));
}

void extend_by_curve(const Curve& curve, LoopBox& box) {
  std::vector<Uv> points;
  for (int i = 0; i <= kSamples; ++i) {
    points.push_back(curve.evaluate(static_cast<double>(i) / kSamples));
    box.extend(points.back());
  }
  for (const double sign : {-1.0, 1.0}) {
    extend_by_greatest(
        curve, [sign](Uv uv) { return sign * uv.u; }, points, box);
    extend_by_greatest(
        curve, [sign](Uv uv) { return sign * uv.v; }, points, box);
  }
}

double shift_along(double from, double to, double other_from, double other_to, double period) {
  if (!(period > 0)) return 0;
  const double slack = 0.5 * ((to - from) - (other_to - other_from));
  // From the middle of what it may be: 0 where it lies inside already.
  const double miss = 0.5 * (from + to) - 0.5 * (other_from + other_to);
  if (std::abs(miss) <= slack) return 0;
  return period * std::round(miss / period);
}

}  // namespace

void LoopBox::extend(Uv uv) {
  u0 = std::min(u0, uv.u);
  u1 = std::max(u1, uv.u);
  v0 = std::min(v0, uv.v);
  v1 = std::max(v1, uv.v);
}

void LoopBox::extend(const LoopBox& other) {
  extend(Uv{other.u0, other.v0});
  extend(Uv{other.u1, other.v1});
}

Uv LoopBox::shift_inside(const LoopBox& other, double period_u, double period_v) const {
  return {shift_along(u0, u1, other.u0, other.u1, period_u),
          shift_along(v0, v1, other.v0, other.v1, period_v)};
}

LoopBox box_of(const std::vector<FaceEdge>& loop) {
  LoopBox box;
  for (const FaceEdge& edge : loop) {
    const auto curve = make_curve(edge.curve);
    const bool is_straight = dynamic_cast<const SegmentCurve*>(curve.get()) != nullptr;
    if (is_straight) {
      box.extend(curve->evaluate(0));
      box.extend(curve->evaluate(1));
    } else {
      extend_by_curve(*curve, box);
    }
  }
  return box;
}

}  // namespace surfmesh
