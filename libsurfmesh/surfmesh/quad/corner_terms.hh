// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace surfmesh {

/// What the shape and size of a corner of a quad depend on, with sides e1 and e2 in the metric M at
/// the corner: the sum of squares s = e1ᵀMe1 + e2ᵀMe2 and the area d = √det M (e1 × e2). Both are 2
/// and 1 at the corner of a unit square.
struct CornerMeasure {
  double s = 0;
  double d = 0;
};

/// How much the size of a corner counts in its energy if its shape counts 1.
///
/// With J the matrix of both sides in an orthonormal frame, the energy is
/// w (|J|² + |J⁻¹|² − 4) + 4 (|J|²/det J − 2), zero for the corner of a unit square.
struct EnergyWeights {
  double size = 1;
  /// True for e (1 + 3 e²) in place of the energy e, which gives the worst corner the most weight.
  bool is_steep = false;
};

namespace detail {

/// In place of the area stands h(d) = (d + √(d² + 4·0.05²)) / 2, which is positive everywhere, so
/// that the energy is finite and leads out of inverted quads.
inline constexpr double kBarrier = 4 * 0.05 * 0.05;

/// Added to the sum of squares: without it a quad of no size would be rewarded by far. Where the
/// size counts less than 0.27 it still is, a little; 0.1 would end that, but costs as much
/// elsewhere.
inline constexpr double kLeastSum = 0.05;

}  // namespace detail

/// The energy that gives the worst corners the most weight.
inline double steep(double energy) { return energy * (1 + 3 * energy * energy); }

/// The energy of a corner.
inline double corner_energy(CornerMeasure corner, EnergyWeights weights) {
  const double h = 0.5 * (corner.d + std::sqrt(corner.d * corner.d + detail::kBarrier));
  const double inverse = 1 / h, s = (corner.s + detail::kLeastSum) * inverse;
  const double size = corner.s + s * inverse - 4 - detail::kLeastSum;
  const double shape = s - 2 - detail::kLeastSum;
  const double energy = weights.size * size + 4 * shape;
  return weights.is_steep ? steep(energy) : energy;
}

/// A step in the chart of a vertex, in which the metric at the vertex is the unit matrix.
struct ChartStep {
  double x = 0;
  double y = 0;
};

/// How the measure of a corner depends on the step of a vertex: s is quadratic, d linear.
struct CornerTerms {
  CornerMeasure at;                     ///< without a step
  double s_x = 0, s_y = 0;              ///< first derivatives
  double d_x = 0, d_y = 0;              ///<
  double s_xx = 0, s_xy = 0, s_yy = 0;  ///< second ones

  CornerMeasure after(ChartStep step) const {
    const double quadratic =
        0.5 * (s_xx * step.x * step.x + s_yy * step.y * step.y) + s_xy * step.x * step.y;
    return {at.s + s_x * step.x + s_y * step.y + quadratic, at.d + d_x * step.x + d_y * step.y};
  }
};

}  // namespace surfmesh
