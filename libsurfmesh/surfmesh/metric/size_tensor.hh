// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {

/// The wanted edge lengths of a size tensor and their directions.
struct PrincipalSizes {
  double l_s = kUnset;    ///< the larger length, model units
  double l_t = kUnset;    ///< the smaller length, across
  double angle = kUnset;  ///< of l_s from the first tangent axis, radians in [−π/2, π/2]
};

/// Build H = R(α) diag(l_s, l_t) R(α)ᵀ; either length may be the larger one.
///
/// Units    lengths in model units, angle in radians from the first tangent axis
/// Source   paper, eq. (1), made symmetric
SizeTensor size_tensor(double l_s, double l_t, double angle);

/// The same with the cosine and the sine of 2α.
inline SizeTensor size_tensor(double l_s, double l_t, double cos2, double sin2) {
  const double mean = 0.5 * (l_s + l_t), radius = 0.5 * (l_s - l_t);
  return {mean + radius * cos2, radius * sin2, mean - radius * cos2};
}

/// The size tensor that asks for one length in all directions.
inline SizeTensor isotropic(double size) { return {size, 0, size}; }

/// Multiply both lengths.
inline SizeTensor scaled(const SizeTensor& h, double factor) {
  return {factor * h.h11, factor * h.h12, factor * h.h22};
}

/// Find the lengths and the direction of the larger one; angle 0 where they are equal.
///
/// Error    rounding of the larger length in both, so 1e-16 × aspect in the smaller one
///          (test PrincipalSizes.*)
PrincipalSizes principal_sizes(const SizeTensor& h);

/// The smaller and the greater length of a size tensor, without their directions.
struct SizeRange {
  double least;
  double greatest;
};

/// Find the two lengths.
///
/// Cost     4 ns: half of principal_sizes, which needs an angle
/// Error    as principal_sizes
inline SizeRange size_range(const SizeTensor& h) {
  const double greatest = 0.5 * (h.h11 + h.h22) + eigenvalue_radius(0.5 * (h.h11 - h.h22), h.h12);
  return {determinant(h) / greatest, greatest};
}

/// Clamp both lengths to [hmin, hmax] and keep the directions; unchanged if both are inside.
///
/// Pre      0 < hmin <= hmax
SizeTensor clamp_sizes(const SizeTensor& h, double hmin, double hmax);

/// The matrix logarithm log H. Averages of it are geometric in the lengths.
/// Pre      positive definite
SizeTensor log_size(const SizeTensor& h);

/// The tensor whose logarithm is given: the inverse of log_size.
/// Error    1e-15 × aspect (test LogSize.*)
SizeTensor exp_size(const SizeTensor& log_h);

/// Limit the larger length to `stretch` times the smaller one; unchanged if it is not greater.
///
/// Pre      stretch >= 1
SizeTensor limit_stretch(const SizeTensor& h, double stretch);

/// The size tensor that a metric in (u,v) asks for: the inverse of metric_from_size.
///
/// Error    rounding × aspect² of the metric, which is what its three numbers can hold
///          (test SizeFromMetric.*)
/// Pre      both are regular; at a pole M determines no size along the direction that vanishes
SizeTensor size_from_metric(const FirstFormFactor& p, const Metric& m);

}  // namespace surfmesh
