// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

/// A unit vector in the orthonormal frame of a metric.
struct Direction {
  double c = 1;  ///< cosine of the angle from the first axis
  double s = 0;  ///< its sine

  Direction quarter_turn() const { return {-s, c}; }

  /// Turned by an angle, which is exact to third order; the length stays 1.
  Direction turned(double angle) const {
    const double t = 0.5 * angle, scale = 1 / (1 + t * t);
    const double cosine = (1 - t * t) * scale, sine = 2 * t * scale;
    return {c * cosine - s * sine, s * cosine + c * sine};
  }
};

/// The symmetric root S of a metric, M = S S. Its frame, the columns of S⁻¹, is orthonormal in the
/// metric and turns as little against the axes of (u,v) as any.
struct RootFrame {
  double s11 = kUnset, s12 = kUnset, s22 = kUnset;

  RootFrame() = default;
  explicit RootFrame(const Metric& m) {
    const double root = density(m);
    const double scale = 1 / std::sqrt(m.m11 + m.m22 + 2 * root);
    s11 = scale * (m.m11 + root);
    s12 = scale * m.m12;
    s22 = scale * (m.m22 + root);
  }

  double determinant_of_root() const { return s11 * s22 - s12 * s12; }

  /// A step in (u,v), in the frame.
  Uv in_frame(Uv step) const { return {s11 * step.u + s12 * step.v, s12 * step.u + s22 * step.v}; }

  /// The step of metric length 1 in a direction.
  Uv step(Direction d) const {
    const double scale = 1 / determinant_of_root();
    return {scale * (s22 * d.c - s12 * d.s), scale * (s11 * d.s - s12 * d.c)};
  }

  /// How far a step goes along a direction, and how far to its left.
  Uv along(Direction d, Uv step) const {
    const Uv x = in_frame(step);
    return {d.c * x.u + d.s * x.v, d.c * x.v - d.s * x.u};
  }
};

/// The Levi-Civita connection of a metric in its root frame, ω = a e¹ + b e²: a vector that is
/// carried along a step in parallel turns by ω(step) against the frame.
///
/// For an isotropic size h it is the gradient of ln h, turned by 90°.
struct Connection {
  Uv form{0, 0};  ///< ω as a row: the angle of a step is form · step

  double angle(Uv step) const { return form.u * step.u + form.v * step.v; }
};

/// The connection from the root frame at a point and the derivatives of the roots along its two
/// axes.
///
/// Source   Cartan's structure equations de¹ = −ω ∧ e², de² = ω ∧ e¹
inline Connection connection_from(const RootFrame& at, const RootFrame& along_first,
                                  const RootFrame& along_second) {
  const auto by_u = [&](double first, double second) { return at.s11 * first + at.s12 * second; };
  const auto by_v = [&](double first, double second) { return at.s12 * first + at.s22 * second; };
  const double scale = -1 / at.determinant_of_root();
  const double a =
      scale * (by_u(along_first.s12, along_second.s12) - by_v(along_first.s11, along_second.s11));
  const double b =
      scale * (by_u(along_first.s22, along_second.s22) - by_v(along_first.s12, along_second.s12));
  return {{a * at.s11 + b * at.s12, a * at.s12 + b * at.s22}};
}

}  // namespace surfmesh
