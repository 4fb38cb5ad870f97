// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/contour_curvature.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "surfmesh/geometry/parts.hh"
#include "surfmesh/sizes/curvature_length.hh"

namespace surfmesh {
namespace {

/// Parameter distance of the points through which the circle is laid, as a share of one part.
constexpr double kStep = 1.0 / 512;

/// A curve that turns by more than this between those points may have a corner there, in radians: a
/// part that is a whole circle turns by 0.012.
constexpr double kSuspiciousTurn = 0.1;

/// With points nearer by this factor a bend turns less in the same ratio, a corner does not.
constexpr double kNearer = 8;

/// Ratio of the size across a contour to that along it: elements there may be stretched so much.
constexpr double kAcross = 2;

/// Relative difference of sizes, and distance of the chord in sizes, that elements do not show.
constexpr double kTolerance = 0.1;

constexpr int kFirstIntervals = 4;  // of each part
constexpr int kMaxHalvings = 8;

/// Share of its size within which a size holds where there is no gradation.
constexpr double kHalo = 0.5;

/// The circle through three points of a curve, and how far the curve turns between them.
struct Bend {
  double curvature = 0;
  double turn = 0;  ///< radians
};

Bend bend_at(const SpaceCurve& curve, double t, double step) {
  const double middle = std::clamp(t, step, 1 - step);
  const Vec3 p = curve.evaluate(middle);
  const Vec3 a = p - curve.evaluate(middle - step);
  const Vec3 b = curve.evaluate(middle + step) - p;
  const double sine = a.cross(b).norm();
  const double sides = a.norm() * b.norm() * (a + b).norm();
  return {sides > 0 ? 2 * sine / sides : 0, std::atan2(sine, a.dot(b))};
}

/// `width` is that of the part of the curve at t.
double curvature_at(const SpaceCurve& curve, double t, double width) {
  const double step = kStep * width;
  const Bend bend = bend_at(curve, t, step);
  if (bend.turn <= kSuspiciousTurn) return bend.curvature;
  const Bend nearer = bend_at(curve, t, step / kNearer);
  if (nearer.turn <= 0.5 * bend.turn) return nearer.curvature;
  return std::min(bend_at(curve, t - step, step).curvature,
                  bend_at(curve, t + step, step).curvature);
}

class Sampler {
 public:
  Sampler(const SpaceCurve& curve, const ResolvedSizing& sizing)
      : curve_(curve),
        breaks_(curve.breaks()),
        grade_(sizing.grade),
        length_(sizing),
        bounds_(sizing.bounds) {}

  std::vector<PlacedSize> run() {
    CurveSample last = at(0);
    const std::vector<double> ends = divided_parts(breaks_, kFirstIntervals);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const CurveSample next = at(ends[i]);
      divide(last, next, 0);
      last = next;
    }
    return std::move(sizes_);
  }

 private:
  struct CurveSample {
    double t;
    Vec3 point;
    double size;
  };

  CurveSample at(double t) const {
    const double size = length_.of_curve(curvature_at(curve_, t, part_width(breaks_, t)));
    return {t, curve_.evaluate(t), bounds_.clamp(size)};
  }

  void divide(const CurveSample& a, const CurveSample& b, int depth) {
    const CurveSample middle = at(0.5 * (a.t + b.t));
    const double least = std::min({a.size, b.size, middle.size});
    const double sagitta = (middle.point - 0.5 * (a.point + b.point)).norm();
    const bool is_linear = std::abs(middle.size - 0.5 * (a.size + b.size)) <= kTolerance * least;
    if (depth < kMaxHalvings && least < bounds_.hmax &&
        !(is_linear && sagitta <= kTolerance * least)) {
      divide(a, middle, depth + 1);
      divide(middle, b, depth + 1);
    } else if (least < bounds_.hmax) {
      add(a, b);
    }
  }

  void add(const CurveSample& a, const CurveSample& b) {
    PlacedSize placed;
    placed.from = a.point;
    placed.to = b.point;
    placed.at_from = {a.size, bounds_.clamp(kAcross * a.size)};
    placed.at_to = {b.size, bounds_.clamp(kAcross * b.size)};
    placed.follows_segment = true;
    if (grade_ == 0) placed.radius = kHalo * std::max(a.size, b.size);
    sizes_.push_back(placed);
  }

  const SpaceCurve& curve_;
  std::vector<double> breaks_;
  double grade_;
  CurvatureLength length_;
  const SizeBounds& bounds_;
  std::vector<PlacedSize> sizes_;
};

}  // namespace

double curve_curvature(const SpaceCurve& curve, double t) {
  return curvature_at(curve, t, part_width(curve.breaks(), t));
}

std::vector<PlacedSize> contour_curvature_sizes(const SpaceCurve& curve,
                                                const ResolvedSizing& sizing) {
  return Sampler(curve, sizing).run();
}

}  // namespace surfmesh
