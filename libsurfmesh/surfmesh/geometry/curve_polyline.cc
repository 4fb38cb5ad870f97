// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/curve_polyline.hh"

#include <cstddef>

#include "surfmesh/geometry/parts.hh"

namespace surfmesh {
namespace {

/// The first intervals of each part, each seen at four places.
constexpr int kFirstIntervals = 8;

constexpr int kMaxSegmentHalvings = 9;

double distance_from_chord(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (p - a - nearest_share(a, b, p) * (b - a)).norm();
}

class Divider {
 public:
  Divider(const SpaceCurve& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {}

  std::vector<CurvePoint> run() {
    points_.push_back(at(0));
    const std::vector<double> ends = divided_parts(curve_.breaks(), kFirstIntervals);
    for (std::size_t i = 1; i < ends.size(); ++i) divide(points_.back(), at(ends[i]), 0);
    return std::move(points_);
  }

 private:
  CurvePoint at(double t) const { return {t, curve_.evaluate(t)}; }

  /// Add the points after a, up to and with b.
  void divide(CurvePoint a, const CurvePoint& b, int depth) {
    const CurvePoint middle = at(0.5 * (a.t + b.t));
    bool is_near = distance_from_chord(middle.point, a.point, b.point) <= tolerance_;
    for (const double share : {0.25, 0.75}) {
      if (!is_near) break;
      const Vec3 p = curve_.evaluate((1 - share) * a.t + share * b.t);
      is_near = distance_from_chord(p, a.point, b.point) <= tolerance_;
    }
    if (is_near || depth == kMaxSegmentHalvings) {
      points_.push_back(b);
      return;
    }
    divide(a, middle, depth + 1);
    divide(middle, b, depth + 1);
  }

  const SpaceCurve& curve_;
  double tolerance_;
  std::vector<CurvePoint> points_;
};

}  // namespace

std::vector<CurvePoint> curve_polyline(const SpaceCurve& curve, double tolerance) {
  return Divider(curve, tolerance).run();
}

double length(const std::vector<CurvePoint>& polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    sum += (polyline[i].point - polyline[i - 1].point).norm();
  }
  return sum;
}

}  // namespace surfmesh
