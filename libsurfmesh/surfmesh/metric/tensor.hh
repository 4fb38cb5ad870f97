// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/first_form.hh"

namespace surfmesh {

/// Squared metric length eᵀMe of a parameter step.
inline double squared_length(const Metric& m, Uv e) {
  return m.m11 * e.u * e.u + 2 * m.m12 * e.u * e.v + m.m22 * e.v * e.v;
}

/// Inner product aᵀMb of two parameter steps.
inline double inner_product(const Metric& m, Uv a, Uv b) {
  return m.m11 * a.u * b.u + m.m12 * (a.u * b.v + a.v * b.u) + m.m22 * a.v * b.v;
}

/// The square of the metric area of a unit of area.
inline double determinant(const Metric& m) { return m.m11 * m.m22 - m.m12 * m.m12; }

/// The product of the two lengths.
inline double determinant(const SizeTensor& h) { return h.h11 * h.h22 - h.h12 * h.h12; }

/// Half the difference of the eigenvalues of a symmetric matrix, from half the difference of its
/// diagonal entries and from its other entry. A plain root: entries whose squares overflow or
/// underflow are of no use elsewhere either, and std::hypot took a seventh of all time.
inline double eigenvalue_radius(double half_difference, double other) {
  return std::sqrt(half_difference * half_difference + other * other);
}

/// Arithmetic mean of two metrics.
inline Metric mean(const Metric& a, const Metric& b) {
  return {0.5 * (a.m11 + b.m11), 0.5 * (a.m12 + b.m12), 0.5 * (a.m22 + b.m22)};
}

/// Arithmetic mean of three metrics.
inline Metric mean(const Metric& a, const Metric& b, const Metric& c) {
  constexpr double third = 1.0 / 3.0;
  return {third * (a.m11 + b.m11 + c.m11), third * (a.m12 + b.m12 + c.m12),
          third * (a.m22 + b.m22 + c.m22)};
}

/// Metric in (u,v) that asks for the sizes H: M = M_p H⁻² M_pᵀ.
inline Metric metric_from_size(const FirstFormFactor& p, const SizeTensor& h) {
  const double scale = 1 / determinant(h);
  const double i11 = scale * h.h22, i12 = -scale * h.h12, i22 = scale * h.h11;
  const double b11 = p.l11 * i11, b12 = p.l11 * i12;
  const double b21 = p.l21 * i11 + p.l22 * i12, b22 = p.l21 * i12 + p.l22 * i22;
  return {b11 * b11 + b12 * b12, b11 * b21 + b12 * b22, b21 * b21 + b22 * b22};
}

/// Squared relative half difference of two lengths below which edge_length uses its series: there,
/// the first omitted term, 44/945 of the cube, is below rounding.
inline constexpr double kNearlyEqualLengths = 1e-6;

/// Metric length of an edge from its lengths in the metrics of its two ends: (l0−l1)/ln(l0/l1),
/// exact for a size that changes geometrically. 0 if either is 0, NaN if either is NaN.
/// Error    below 1e-12 relative where the series is used (test EdgeLength.*)
inline double edge_length(double l0, double l1) {
  const double sum = l0 + l1;
  const double x = (l0 - l1) / sum;
  const double y = x * x;
  // ln(l0/l1) = 2 artanh(x), and the series is that of x/artanh(x).
  if (y < kNearlyEqualLengths) return 0.5 * sum * (1 - y * (1.0 / 3.0 + y * 4.0 / 45.0));
  return l0 <= 0 || l1 <= 0 ? 0 : (l0 - l1) / std::log(l0 / l1);
}

}  // namespace surfmesh
