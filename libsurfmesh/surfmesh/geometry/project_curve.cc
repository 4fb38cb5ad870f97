// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_curve.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_to_surface.hh"

namespace surfmesh {
namespace {

/// The first steps along the curve, and the halvings of one of them.
constexpr int kFirstSteps = 64;
constexpr int kMaxStepHalvings = 16;

/// The middle of a step is this near to that of its chord, as a share of its length: Newton then
/// has a good start anywhere on the step.
constexpr double kStraightness = 0.1;

/// Steps shorter than this, in shares of the domain, need not be straight: they are rounding.
constexpr double kNegligibleStep = 1e-10;

/// The shortest step in t may be a kink, but leads no farther than this share of the domain.
constexpr double kLongestKink = 1e-3;

/// A step leads no farther than this share of the domain, so that none leaps from side to side.
constexpr double kLongestStep = 0.25;

/// A point of the curve and its parameters.
struct Station {
  double t = 0;
  Uv uv;
};

/// A curve in space and the stations from which its parameters are found.
class ProjectedCurve : public Curve {
 public:
  ProjectedCurve(std::shared_ptr<const Surface> surface, std::shared_ptr<const SpaceCurve> curve,
                 std::vector<Station> stations)
      : surface_(std::move(surface)), curve_(std::move(curve)), stations_(std::move(stations)) {}

  Uv evaluate(double t) const override {
    const auto after =
        std::upper_bound(stations_.begin() + 1, stations_.end() - 1, t,
                         [](double value, const Station& station) { return value < station.t; });
    const Station& a = *(after - 1);
    const Uv guess = lerp(a.uv, after->uv, (t - a.t) / (after->t - a.t));
    return project_to_surface(*surface_, curve_->evaluate(t), guess).uv;
  }

 private:
  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const SpaceCurve> curve_;
  std::vector<Station> stations_;
};

/// Goes along the curve, step by step.
class Follower {
 public:
  Follower(const Surface& surface, const SpaceCurve& curve, double reach)
      : surface_(surface), curve_(curve), domain_(surface.domain()), reach_(reach) {}

  /// The stations from this start to the end, or to where the curve cannot be followed.
  std::vector<Station> run(Uv start) {
    stations_ = {{0, start}};
    for (int i = 1; i <= kFirstSteps; ++i) {
      if (!follow(double(i) / kFirstSteps, kMaxStepHalvings)) break;
    }
    return stations_;
  }

 private:
  bool follow(double t, int halvings) {
    const Station from = stations_.back();
    const std::optional<Uv> uv = find_uv(t, guess(t));
    if (uv && is_straight(from, {t, *uv})) {
      stations_.push_back({t, *uv});
      return true;
    }
    if (halvings == 0) {
      if (!uv || distance(from.uv, *uv) > kLongestKink) return false;
      stations_.push_back({t, *uv});
      return true;
    }
    return follow((from.t + t) / 2, halvings - 1) && follow(t, halvings - 1);
  }

  /// Straight on from the last two stations.
  Uv guess(double t) const {
    const Station& last = stations_.back();
    if (stations_.size() == 1) return last.uv;
    const Station& before = stations_[stations_.size() - 2];
    return lerp(before.uv, last.uv, (t - before.t) / (last.t - before.t));
  }

  std::optional<Uv> find_uv(double t, Uv guess) const {
    const SurfaceFoot foot = project_to_surface(surface_, curve_.evaluate(t), guess);
    if (!(foot.distance < reach_)) return std::nullopt;
    return foot.uv;
  }

  bool is_straight(const Station& a, const Station& b) const {
    const Uv middle = lerp(a.uv, b.uv, 0.5);
    const std::optional<Uv> uv = find_uv((a.t + b.t) / 2, middle);
    const double length = distance(a.uv, b.uv);
    return uv && distance(*uv, middle) <= std::max(kStraightness * length, kNegligibleStep) &&
           length <= kLongestStep;
  }

  /// In shares of the domain.
  double distance(Uv a, Uv b) const {
    return std::hypot((b.u - a.u) / (domain_.u1 - domain_.u0),
                      (b.v - a.v) / (domain_.v1 - domain_.v0));
  }

  const Surface& surface_;
  const SpaceCurve& curve_;
  Domain domain_;
  double reach_;
  std::vector<Station> stations_;
};

/// Fail if a point of the curve is off the surface.
void check_distance(const Surface& surface, const SpaceCurve& curve, double reach,
                    const CurveRange& range) {
  double greatest = 0, at = 0;
  for (int i = 0; i <= kFirstSteps; ++i) {
    const double t = double(i) / kFirstSteps;
    const double gap = find_near_points(surface, curve.evaluate(t)).front().distance;
    if (gap > greatest) std::tie(greatest, at) = std::pair(gap, t);
  }
  if (greatest < reach) return;
  throw Error(ErrorCode::Geometry,
              fmt::format("its distance from the patch at t = {:.6g} is {:.3g}, which must be "
                          "below {:.3g}",
                          range.at(at), greatest, reach));
}

}  // namespace

std::shared_ptr<const Curve> project_curve(std::shared_ptr<const Surface> surface,
                                           std::shared_ptr<const SpaceCurve> curve, double reach,
                                           const CurveRange& range) {
  Follower follower(*surface, *curve, reach);
  Station farthest;
  for (const SurfaceFoot& start : find_near_points(*surface, curve->evaluate(0))) {
    if (!(start.distance < reach)) break;
    std::vector<Station> stations = follower.run(start.uv);
    if (stations.back().t == 1) {
      return std::make_shared<ProjectedCurve>(std::move(surface), std::move(curve),
                                              std::move(stations));
    }
    if (stations.back().t >= farthest.t) farthest = stations.back();
  }
  check_distance(*surface, *curve, reach, range);
  throw Error(ErrorCode::Geometry,
              fmt::format("it leaves the domain at t = {:.6g}, (u,v) = ({:.6g}, {:.6g}); divide it "
                          "where it crosses a side",
                          range.at(farthest.t), farthest.uv.u, farthest.uv.v));
}

}  // namespace surfmesh
