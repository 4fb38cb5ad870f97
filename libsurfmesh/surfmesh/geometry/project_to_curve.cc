// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_to_curve.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace surfmesh {
namespace {

/// Step of the differences for a curve's tangent, a power of two so that t ± h is exact. The
/// truncation, h²/3 of the third derivative, is about 1e-8; the rounding is 1e-12 of the parameter
/// range. Neither displaces the foot of a point on the curve, only the rate at which it is reached.
constexpr double kTangentStep = 0x1p-13;

/// A foot this near, in units of the curve's speed, is the nearest point of the curve (or as good).
constexpr double kOnCurve = 1e-7;

/// Points this near, in units of the curve's extent or speed, are one point in space: some thousand
/// roundings. Among the points of a curve that are one, the guess decides.
constexpr double kSamePoint = 1e-12;

/// Evaluations round to a few units in the last digit of the coordinates; far from the origin that
/// is more than kSamePoint.
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

/// A step in t below this does not move the curve's point by more than its own rounding.
constexpr double kLeastStep = std::numeric_limits<double>::epsilon();

constexpr int kScanIntervals = 32;
constexpr int kMaxNewtonSteps = 12;
/// Halvings that bring an interval of length 2/32 down to the rounding of t.
constexpr int kMaxNewtonHalvings = 50;
constexpr int kMaxRootSteps = 100;

Uv tangent_uv(const Curve& curve, double t) {
  const double h = kTangentStep;
  if (t < h) {
    const Uv twice = 4.0 * (curve.evaluate(t + h) - curve.evaluate(t));
    return 1 / (2 * h) * (twice - (curve.evaluate(t + 2 * h) - curve.evaluate(t)));
  }
  if (t > 1 - h) {
    const Uv twice = 4.0 * (curve.evaluate(t) - curve.evaluate(t - h));
    return 1 / (2 * h) * (twice - (curve.evaluate(t) - curve.evaluate(t - 2 * h)));
  }
  return 1 / (2 * h) * (curve.evaluate(t + h) - curve.evaluate(t - h));
}

/// A point of the curve as seen from the point: half the squared distance has the derivative
/// slope().
struct Foot {
  double t = 0;
  Vec3 offset;
  Vec3 tangent;

  double squared_distance() const { return offset.squaredNorm(); }
  double slope() const { return tangent.dot(offset); }
  /// Gauss-Newton: quadratic for a point on the curve. Not finite where the tangent vanishes.
  double newton() const { return t - slope() / tangent.squaredNorm(); }
};

/// Three points in order, the middle one the nearest of them.
struct Bracket {
  Foot low;
  Foot middle;
  Foot high;
};

class Projection {
 public:
  Projection(const Surface& surface, const Curve& curve, const Vec3& point)
      : surface_(&surface), curve_(&curve), point_(point) {}

  std::optional<double> follow(double t) const;
  double search(double t_guess) const;

 private:
  Foot at(double t) const;
  double squared_distance(double t) const;
  /// Distance within which points are one, for a curve of this extent or speed.
  double same_point(double extent) const {
    return std::max(kSamePoint * extent, kRounding * point_.lpNorm<Eigen::Infinity>());
  }
  std::array<double, kScanIntervals + 1> scan() const;
  double refine(int sample) const;
  Bracket narrow(Bracket bracket) const;
  double root(const Bracket& bracket) const;

  const Surface* surface_;
  const Curve* curve_;
  Vec3 point_;
};

Foot Projection::at(double t) const {
  const Jet jet = surface_->evaluate(curve_->evaluate(t), Order::First);
  const Uv step = tangent_uv(*curve_, t);
  return {t, jet.point - point_, step.u * jet.du + step.v * jet.dv};
}

double Projection::squared_distance(double t) const {
  return (surface_->evaluate(curve_->evaluate(t), Order::Position).point - point_).squaredNorm();
}

/// Newton from t until it brings no more; nothing unless that ends on the curve. An end of the
/// curve has to be met exactly: a point a little beyond may be before the other end of a closed
/// curve.
std::optional<double> Projection::follow(double t) const {
  Foot foot = at(t);
  for (int i = 0; i < kMaxNewtonSteps; ++i) {
    const double next = foot.newton();
    if (!std::isfinite(next)) break;
    const Foot next_foot = at(std::clamp(next, 0.0, 1.0));
    if (next_foot.squared_distance() >= foot.squared_distance()) break;
    foot = next_foot;
  }
  const bool is_end = foot.t == 0 || foot.t == 1;
  const double speed = foot.tangent.norm();
  const double reach = is_end ? same_point(speed) : std::max(kOnCurve * speed, same_point(speed));
  if (foot.squared_distance() > reach * reach) return std::nullopt;
  return foot.t;
}

/// Squared distances of evenly spread samples.
std::array<double, kScanIntervals + 1> Projection::scan() const {
  std::array<double, kScanIntervals + 1> squares{};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = squared_distance(double(i) / kScanIntervals);
  }
  return squares;
}

/// Halve the bracket until the slope changes its sign over it, or it is as small as the rounding
/// of t. Needs values only, so it also passes points where the tangent vanishes.
Bracket Projection::narrow(Bracket b) const {
  for (int i = 0; i < kMaxNewtonHalvings; ++i) {
    if (b.low.slope() < 0 && b.high.slope() > 0) break;
    const Foot left = at((b.low.t + b.middle.t) / 2);
    const Foot right = at((b.middle.t + b.high.t) / 2);
    if (left.squared_distance() < b.middle.squared_distance()) {
      b.high = b.middle;
      b.middle = left;
    } else if (right.squared_distance() < b.middle.squared_distance()) {
      b.low = b.middle;
      b.middle = right;
    } else {
      b.low = left;
      b.high = right;
    }
  }
  return b;
}

/// The zero of the slope in a bracket over which it rises from negative to positive: Newton, and
/// bisection where Newton leaves the bracket or does not halve the slope.
double Projection::root(const Bracket& bracket) const {
  double low = bracket.low.t;
  double high = bracket.high.t;
  double last_slope = std::numeric_limits<double>::infinity();
  Foot foot = bracket.middle;
  for (int i = 0; i < kMaxRootSteps; ++i) {
    const double slope = foot.slope();
    if (slope == 0) break;
    (slope < 0 ? low : high) = foot.t;
    double next = foot.newton();
    if (!(next > low && next < high) || std::abs(slope) > last_slope / 2) next = (low + high) / 2;
    last_slope = std::abs(slope);
    if (std::abs(next - foot.t) <= kLeastStep) break;
    foot = at(next);
  }
  return foot.t;
}

/// The nearest point between the neighbours of a sample that is nearer than these.
double Projection::refine(int sample) const {
  const auto foot = [&](int i) {
    return at(double(std::clamp(i, 0, kScanIntervals)) / kScanIntervals);
  };
  Bracket bracket{foot(sample - 1), foot(sample), foot(sample + 1)};
  if (sample == 0 && bracket.middle.slope() > 0) return 0;
  if (sample == kScanIntervals && bracket.middle.slope() < 0) return 1;
  bracket = narrow(bracket);
  const bool has_root = bracket.low.slope() < 0 && bracket.high.slope() > 0;
  return has_root ? root(bracket) : bracket.middle.t;
}

/// The nearest point next to the nearest samples, which are several where the curve is closed.
double Projection::search(double t_guess) const {
  const auto squares = scan();
  const auto [least, greatest] = std::minmax_element(squares.begin(), squares.end());
  const double same = std::pow(same_point(std::sqrt(*greatest)), 2);
  if (*greatest <= *least + same) return t_guess;
  double best = t_guess;
  double best_square = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kScanIntervals; ++i) {
    if (squares[static_cast<std::size_t>(i)] > *least + same) continue;
    const double t = refine(i);
    const double square = squared_distance(t);
    const bool is_nearer_guess = std::abs(t - t_guess) < std::abs(best - t_guess);
    if (square < best_square - same || (square <= best_square + same && is_nearer_guess)) {
      best = t;
      best_square = square;
    }
  }
  return best;
}

}  // namespace

double project_to_curve(const Surface& surface, const Curve& curve, const Vec3& point,
                        double t_guess) {
  const double guess = std::isfinite(t_guess) ? std::clamp(t_guess, 0.0, 1.0) : 0.0;
  const Projection projection(surface, curve, point);
  if (const std::optional<double> t = projection.follow(guess)) return *t;
  return projection.search(guess);
}

}  // namespace surfmesh
