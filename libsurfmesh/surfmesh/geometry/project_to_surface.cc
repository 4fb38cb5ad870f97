// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_to_surface.hh"

#include <algorithm>
#include <cmath>

namespace surfmesh {
namespace {

/// Damping that is always there, as a share of the trace: keeps the system solvable at poles
/// without changing a step that the surface decides.
constexpr double kLeastDamping = 1e-14;

/// First damping after a step that led away.
constexpr double kFirstDamping = 1e-3;
constexpr double kDampingFactor = 10;

/// After a step below this share of the domain the next one would be below the rounding of the
/// parameters, as convergence is quadratic for points on the surface.
constexpr double kLastStep = 1e-9;

constexpr int kMaxSteps = 60;
constexpr int kGridIntervals = 32;

/// The point of the surface at relative parameters s, t in [0,1].
struct Candidate {
  double s = 0;
  double t = 0;
  Vec3 offset;  ///< from the point that is projected
  Vec3 ds;
  Vec3 dt;

  double square() const { return offset.squaredNorm(); }
};

class Descent {
 public:
  Descent(const Surface& surface, const Vec3& point)
      : surface_(surface), domain_(surface.domain()), point_(point) {}

  SurfaceFoot run(Uv guess) const {
    Candidate here = at((guess.u - domain_.u0) / (domain_.u1 - domain_.u0),
                        (guess.v - domain_.v0) / (domain_.v1 - domain_.v0));
    double damping = 0;
    for (int i = 0; i < kMaxSteps; ++i) {
      const Candidate next = step(here, damping);
      const double length = std::max(std::abs(next.s - here.s), std::abs(next.t - here.t));
      if (next.square() < here.square()) {
        here = next;
        damping = damping > kFirstDamping ? damping / kDampingFactor : 0;
      } else {
        damping = std::max(kFirstDamping, kDampingFactor * damping);
      }
      if (length <= kLastStep) break;
    }
    return {domain_.at(here.s, here.t), here.offset.norm()};
  }

 private:
  Candidate at(double s, double t) const {
    s = std::clamp(s, 0.0, 1.0);
    t = std::clamp(t, 0.0, 1.0);
    const Jet jet = surface_.evaluate(domain_.at(s, t), Order::First);
    return {s, t, jet.point - point_, (domain_.u1 - domain_.u0) * jet.du,
            (domain_.v1 - domain_.v0) * jet.dv};
  }

  /// True if the parameter is at an end of its range and would leave it.
  static bool is_blocked(double x, double slope) {
    return (x <= 0 && slope > 0) || (x >= 1 && slope < 0);
  }

  /// One step of Levenberg and Marquardt within the domain.
  Candidate step(const Candidate& p, double damping) const {
    const double slope_s = p.ds.dot(p.offset), slope_t = p.dt.dot(p.offset);
    double ss = p.ds.squaredNorm(), tt = p.dt.squaredNorm();
    const double more = std::max(damping, kLeastDamping) * (ss + tt);
    ss += more;
    tt += more;
    const bool has_s = !is_blocked(p.s, slope_s), has_t = !is_blocked(p.t, slope_t);
    if (!has_s) return has_t ? at(p.s, p.t - slope_t / tt) : p;
    if (!has_t) return at(p.s - slope_s / ss, p.t);
    const double st = p.ds.dot(p.dt);
    const double determinant = ss * tt - st * st;
    if (!(determinant > 0)) return p;
    return at(p.s - (tt * slope_s - st * slope_t) / determinant,
              p.t - (ss * slope_t - st * slope_s) / determinant);
  }

  const Surface& surface_;
  Domain domain_;
  Vec3 point_;
};

/// Squared distances of the places of a regular grid from a point.
class Grid {
 public:
  Grid(const Surface& surface, const Vec3& point) {
    const Domain domain = surface.domain();
    for (int j = 0; j <= kGridIntervals; ++j) {
      for (int i = 0; i <= kGridIntervals; ++i) {
        const Uv uv = domain.at(double(i) / kGridIntervals, double(j) / kGridIntervals);
        squares_.push_back((surface.evaluate(uv, Order::Position).point - point).squaredNorm());
      }
    }
  }

  /// True if no neighbour is nearer.
  bool is_lowest(int i, int j) const {
    for (int l = std::max(0, j - 1); l <= std::min(kGridIntervals, j + 1); ++l) {
      for (int k = std::max(0, i - 1); k <= std::min(kGridIntervals, i + 1); ++k) {
        if (at(k, l) < at(i, j)) return false;
      }
    }
    return true;
  }

 private:
  double at(int i, int j) const {
    return squares_[static_cast<std::size_t>(j * (kGridIntervals + 1) + i)];
  }

  std::vector<double> squares_;
};

}  // namespace

SurfaceFoot project_to_surface(const Surface& surface, const Vec3& point, Uv guess) {
  return Descent(surface, point).run(guess);
}

std::vector<SurfaceFoot> find_near_points(const Surface& surface, const Vec3& point) {
  const Grid grid(surface, point);
  const Descent descent(surface, point);
  const Domain domain = surface.domain();
  std::vector<SurfaceFoot> feet;
  for (int j = 0; j <= kGridIntervals; ++j) {
    for (int i = 0; i <= kGridIntervals; ++i) {
      if (!grid.is_lowest(i, j)) continue;
      feet.push_back(
          descent.run(domain.at(double(i) / kGridIntervals, double(j) / kGridIntervals)));
    }
  }
  std::stable_sort(feet.begin(), feet.end(), [](const SurfaceFoot& a, const SurfaceFoot& b) {
    return a.distance < b.distance;
  });
  return feet;
}

}  // namespace surfmesh
