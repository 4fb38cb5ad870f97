// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/smooth_quads.hh"

#include <algorithm>
#include <cmath>
#include <span>

namespace surfmesh {
namespace {

constexpr double kLongestStep = 0.3;

/// Steps shorter than this are not worth their metric query.
constexpr double kLeastStep = 0.01;

/// A step that does not lower the energy is shortened so often, by this factor.
constexpr int kShortenings = 3;
constexpr double kShortening = 0.4;

/// Least curvature of the energy that a Newton step takes it for: the energy is not convex
/// everywhere.
constexpr double kLeastCurvature = 1;

/// Vertices beside one that moves farther than this are smoothed again.
constexpr double kWakingStep = 0.02;

/// Quads below this scaled Jacobian are polished.
constexpr double kPolished = 0.8;

/// First and second derivatives of the energy by the step of a vertex.
struct Derivatives {
  double g_x = 0, g_y = 0;
  double h_xx = 0, h_xy = 0, h_yy = 0;

  void add_outer(double factor, double a_x, double a_y, double b_x, double b_y) {
    h_xx += 2 * factor * a_x * b_x;
    h_xy += factor * (a_x * b_y + a_y * b_x);
    h_yy += 2 * factor * a_y * b_y;
  }

  /// With e(1 + 3e²) in place of e.
  void add_steep(const Derivatives& of, double energy) {
    const double slope = 1 + 9 * energy * energy;
    add_scaled(of, slope);
    add_outer(9 * energy, of.g_x, of.g_y, of.g_x, of.g_y);
  }

  void add_scaled(const Derivatives& of, double factor) {
    g_x += factor * of.g_x;
    g_y += factor * of.g_y;
    h_xx += factor * of.h_xx;
    h_xy += factor * of.h_xy;
    h_yy += factor * of.h_yy;
  }
};

/// The energy of a corner with its derivatives.
struct CornerEnergy {
  double value = 0;
  Derivatives by;
};

/// With the energy E(s, h(d)): E' = E_s s' + E_h h' d', and likewise for the second derivatives.
CornerEnergy differentiate(const CornerTerms& corner, double size_weight) {
  const double d = corner.at.d, s = corner.at.s + detail::kLeastSum;
  const double root = std::sqrt(d * d + detail::kBarrier);
  const double h = 0.5 * (d + root), inverse = 1 / h, by_root = 1 / root;
  const double inverse2 = inverse * inverse;
  const double h_d = h * by_root;
  const double h_dd = 0.5 * detail::kBarrier * by_root * by_root * by_root;
  const double e_s = size_weight * (1 + inverse2) + 4 * inverse;
  const double e_sh = -inverse2 * (2 * size_weight * inverse + 4);
  const double e_h = s * e_sh;
  const double e_hh = s * inverse2 * inverse * (6 * size_weight * inverse + 8);
  const double e_d = e_h * h_d;
  CornerEnergy result;
  result.value = size_weight * (corner.at.s + s * inverse2 - 4 - detail::kLeastSum) +
                 4 * (s * inverse - 2 - detail::kLeastSum);
  Derivatives& by = result.by;
  by.g_x = e_s * corner.s_x + e_d * corner.d_x;
  by.g_y = e_s * corner.s_y + e_d * corner.d_y;
  by.h_xx = e_s * corner.s_xx;
  by.h_xy = e_s * corner.s_xy;
  by.h_yy = e_s * corner.s_yy;
  by.add_outer(e_sh * h_d, corner.s_x, corner.s_y, corner.d_x, corner.d_y);
  by.add_outer(0.5 * (e_hh * h_d * h_d + e_h * h_dd), corner.d_x, corner.d_y, corner.d_x,
               corner.d_y);
  return result;
}

double energy(std::span<const CornerTerms> star, ChartStep step, EnergyWeights weights) {
  double sum = 0;
  for (const CornerTerms& corner : star) sum += corner_energy(corner.after(step), weights);
  return sum;
}

/// The Newton step, with curvatures raised where they are too low or negative.
ChartStep newton_step(const Derivatives& sum) {
  const double mean = 0.5 * (sum.h_xx + sum.h_yy), half = 0.5 * (sum.h_xx - sum.h_yy);
  const double radius = std::sqrt(half * half + sum.h_xy * sum.h_xy);
  const double raise = std::max(0.0, kLeastCurvature - (mean - radius));
  const double h_xx = sum.h_xx + raise, h_yy = sum.h_yy + raise;
  const double determinant = h_xx * h_yy - sum.h_xy * sum.h_xy;
  ChartStep step{(sum.h_xy * sum.g_y - h_yy * sum.g_x) / determinant,
                 (sum.h_xy * sum.g_x - h_xx * sum.g_y) / determinant};
  const double length = std::sqrt(step.x * step.x + step.y * step.y);
  const double factor = length > kLongestStep ? kLongestStep / length : 1;
  return {factor * step.x, factor * step.y};
}

/// The least scaled Jacobian of the faces around a vertex.
double least_jacobian(const PolyMesh& mesh, const QuadGeometry& geometry, VertexHandle vh) {
  double least = 1;
  for (const FaceHandle fh : mesh.vf_range(vh)) {
    least = std::min(least, geometry.measure(fh).least_jacobian);
  }
  return least;
}

/// Sweeps over the vertices that are awake.
class Sweeps {
 public:
  Sweeps(const PolyMesh& mesh, QuadGeometry& geometry, SmoothingAim aim)
      : mesh_(mesh), geometry_(geometry), smoother_(geometry), aim_(aim) {
    is_awake_.assign(mesh.n_vertices(), aim == SmoothingAim::WorstCorners ? 0 : 1);
    if (aim == SmoothingAim::WorstCorners) wake_bad_quads();
  }

  void run(int sweeps, const RunContext& context) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      bool is_any = false;
      for (std::size_t i = 0; i < is_awake_.size(); ++i) {
        if (i % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
        if (!is_awake_[i]) continue;
        is_awake_[i] = 0;
        const VertexHandle vh(static_cast<int>(i));
        if (!mesh_.halfedge_handle(vh).is_valid() || !geometry_.is_free(vh)) continue;
        if (smooth(vh) <= kWakingStep) continue;
        wake_around(vh);
        is_any = true;
      }
      if (!is_any) return;
    }
  }

 private:
  double smooth(VertexHandle vh) {
    switch (aim_) {
      case SmoothingAim::Shape:
        return smoother_.smooth(vh, {});
      case SmoothingAim::BetterShape:
        return smoother_.smooth(vh, {.size = 0.4});
      case SmoothingAim::WorstCorners:
        return polish(vh);
    }
    return 0;
  }

  double polish(VertexHandle vh) {
    const double before = least_jacobian(mesh_, geometry_, vh);
    if (before >= kPolished) return 0;
    geometry_.begin_trial();
    const double length = smoother_.smooth(vh, {.size = 0.1, .is_steep = true});
    if (length == 0 || least_jacobian(mesh_, geometry_, vh) < before) {
      geometry_.undo_trial();
      return 0;
    }
    geometry_.keep_trial();
    return length;
  }

  void wake_bad_quads() {
    for (const FaceHandle fh : mesh_.faces()) {
      if (!mesh_.halfedge_handle(fh).is_valid()) continue;
      if (geometry_.measure(fh).least_jacobian < kPolished) wake(fh);
    }
  }

  void wake(FaceHandle fh) {
    for (const VertexHandle vh : mesh_.fv_range(fh)) is_awake_[index(vh)] = 1;
  }

  void wake_around(VertexHandle vh) {
    for (const FaceHandle fh : mesh_.vf_range(vh)) wake(fh);
  }

  const PolyMesh& mesh_;
  QuadGeometry& geometry_;
  QuadSmoother smoother_;
  SmoothingAim aim_;
  std::vector<char> is_awake_;
};

}  // namespace

double QuadSmoother::smooth(VertexHandle vh, EnergyWeights weights) {
  if (!geometry_.collect(vh, star_)) return 0;
  Derivatives sum;
  double before = 0;
  for (const CornerTerms& corner : star_) {
    const auto [energy, by] = differentiate(corner, weights.size);
    before += weights.is_steep ? steep(energy) : energy;
    if (weights.is_steep) {
      sum.add_steep(by, energy);
    } else {
      sum.add_scaled(by, 1);
    }
  }
  ChartStep step = newton_step(sum);
  const double length = std::sqrt(step.x * step.x + step.y * step.y);
  if (!(length >= kLeastStep)) return 0;
  double share = 1;
  for (int attempt = 0; attempt <= kShortenings; ++attempt, share *= kShortening) {
    const ChartStep shorter{share * step.x, share * step.y};
    if (energy(star_, shorter, weights) >= before) continue;
    if (geometry_.move(vh, shorter)) return share * length;
  }
  return 0;
}

void smooth_quads(const PolyMesh& mesh, QuadGeometry& geometry, SmoothingAim aim, int sweeps,
                  const RunContext& context) {
  Sweeps(mesh, geometry, aim).run(sweeps, context);
}

}  // namespace surfmesh
