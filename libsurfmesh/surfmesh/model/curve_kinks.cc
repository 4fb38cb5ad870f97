// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/curve_kinks.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "surfmesh/core/error.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// A chord that contains a kink turns at its ends by half of the kink's angle at least (radians).
constexpr double kLeastBend = 2.5 * std::numbers::pi / 180;

/// The shortest stretch of t that is looked at, and the shortest part that is searched.
constexpr double kShortestStretch = 1e-12, kShortestPart = 1e-6;

/// A bend that is still there in a stretch so much shorter than the first one is a kink.
constexpr double kNarrowed = 1e-4;

/// Around a cusp curves nearly stand still, and are soon shorter than rounding: a turn back is one
/// in a longer stretch, too (radians).
constexpr double kCusp = std::numbers::pi / 2, kNarrowedToCusp = 1e-2;

/// Chords are at least so many times as long as coordinates are rounded: then their directions are
/// right to a fiftieth of the least bend.
constexpr double kChordRoundings = 2e3;

/// More of them are not meant: gear wheels have hundreds.
constexpr std::size_t kMostKinks = 2000;

struct Place {
  double t = 0;
  Vec3 point;
};

/// Three places that follow each other.
using Turn = std::array<Place, 3>;

/// Five places that follow each other.
using Stretch = std::array<Place, 5>;

/// The angle by which the way turns at the middle place; 0 where it stands still.
double bend(const Place& a, const Place& b, const Place& c) {
  const Vec3 in = b.point - a.point, out = c.point - b.point;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

double width(const Stretch& stretch) { return stretch.back().t - stretch.front().t; }

/// True if rounding hardly changes the directions of the chords.
bool is_resolved(const Stretch& stretch) {
  for (std::size_t i = 1; i < stretch.size(); ++i) {
    const double chord = (stretch[i].point - stretch[i - 1].point).norm();
    if (chord < kChordRoundings * rounding_at(stretch[i].point)) return false;
  }
  return true;
}

/// The three places at the middle one of which a stretch turns most.
Turn sharpest_turn(const Stretch& stretch) {
  std::size_t sharpest = 1;
  double greatest = 0;
  for (std::size_t i = 1; i + 1 < stretch.size(); ++i) {
    const double angle = bend(stretch[i - 1], stretch[i], stretch[i + 1]);
    if (angle > greatest) sharpest = i, greatest = angle;
  }
  return {stretch[sharpest - 1], stretch[sharpest], stretch[sharpest + 1]};
}

/// True if a place is one of some others.
bool is_among(double t, const std::vector<double>& others) {
  return std::any_of(others.begin(), others.end(),
                     [t](double other) { return std::abs(t - other) < kShortestPart; });
}

class KinkSearch {
 public:
  explicit KinkSearch(const SpaceCurve& curve) : curve_(curve) {}

  std::vector<double> run() {
    search_part(0, 1);
    std::sort(kinks_.begin(), kinks_.end());
    return std::move(kinks_);
  }

 private:
  Place at(double t) const { return {t, curve_.evaluate(t)}; }
  Place between(const Place& a, const Place& b) const { return at(0.5 * (a.t + b.t)); }

  /// Look for kinks inside a part, whose ends may be kinks themselves.
  void search_part(double from, double to) {
    if (to - from < kShortestPart) return;
    std::vector<double> ends = kinks_in(from, to);
    if (ends.empty()) return;
    kinks_.insert(kinks_.end(), ends.begin(), ends.end());
    if (kinks_.size() > kMostKinks) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("it turns sharply at more than {} places, as it does where a formula "
                              "jumps back and forth along it",
                              kMostKinks));
    }
    ends.push_back(to);
    std::sort(ends.begin(), ends.end());
    for (const double end : ends) {
      search_part(from, end);
      from = end;
    }
  }

  /// The kinks that show at the places of a part.
  std::vector<double> kinks_in(double from, double to) const {
    std::vector<Place> places;
    for (const double share : sample_parameters(kLineSamples)) {
      places.push_back(at(from + share * (to - from)));
    }
    std::vector<double> found;
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const auto kink = kink_in({places[i - 1], places[i], places[i + 1]});
      if (kink && !is_among(*kink, found) && !is_among(*kink, {from, to})) found.push_back(*kink);
    }
    return found;
  }

  /// The kink that makes the curve turn. A stretch of four chords is narrowed to the two that turn
  /// most.
  std::optional<double> kink_in(Turn turn) const {
    const double first = turn[2].t - turn[0].t;
    while (bend(turn[0], turn[1], turn[2]) >= kLeastBend) {
      const Stretch stretch = {turn[0], between(turn[0], turn[1]), turn[1],
                               between(turn[1], turn[2]), turn[2]};
      if (width(stretch) < kShortestStretch || !is_resolved(stretch)) {
        const bool is_cusp = bend(turn[0], turn[1], turn[2]) >= kCusp;
        if (width(stretch) > (is_cusp ? kNarrowedToCusp : kNarrowed) * first) return {};
        return turn[1].t;
      }
      turn = sharpest_turn(stretch);
    }
    return {};
  }

  const SpaceCurve& curve_;
  std::vector<double> kinks_;
};

}  // namespace

std::vector<double> curve_kinks(const SpaceCurve& curve) { return KinkSearch(curve).run(); }

}  // namespace surfmesh
