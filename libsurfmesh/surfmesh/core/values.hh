// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A position, direction or derivative in space, in model units.
using Vec3 = Eigen::Vector3d;

/// A number that nobody has set.
inline constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

/// A point, or a step, in the parameters of a patch. NaN until it is set.
struct Uv {
  double u = kUnset;
  double v = kUnset;

  friend bool operator==(const Uv&, const Uv&) = default;
};

/// @{
/// By coordinate.
inline Uv operator+(Uv a, Uv b) { return {a.u + b.u, a.v + b.v}; }
inline Uv operator-(Uv a, Uv b) { return {a.u - b.u, a.v - b.v}; }
inline Uv operator*(double s, Uv a) { return {s * a.u, s * a.v}; }
/// @}

/// The z component of the cross product of two parameter steps.
inline double cross(Uv a, Uv b) { return a.u * b.v - a.v * b.u; }

/// Interpolate linearly, exact at both ends.
inline Uv lerp(Uv a, Uv b, double t) { return {(1 - t) * a.u + t * b.u, (1 - t) * a.v + t * b.v}; }

/// Symmetric positive definite metric M in (u,v): a step e has metric length √(eᵀMe), 1 is wanted.
struct Metric {
  double m11 = kUnset;
  double m12 = kUnset;
  double m22 = kUnset;

  friend bool operator==(const Metric&, const Metric&) = default;
};

/// Size tensor H = R(α) diag(l_s, l_t) R(α)ᵀ in the orthonormal tangent frame whose first axis is
/// along p_u (eq. (1) made symmetric). Eigenvalues are wanted edge lengths in model units.
struct SizeTensor {
  double h11 = kUnset;
  double h12 = kUnset;
  double h22 = kUnset;

  friend bool operator==(const SizeTensor&, const SizeTensor&) = default;
};

/// A unit vector perpendicular to a surface. NaN until it is set.
struct Normal {
  double x = kUnset;
  double y = kUnset;
  double z = kUnset;

  friend bool operator==(const Normal&, const Normal&) = default;
};

/// M_p of eq. (2): the lower triangular factor of the first fundamental form, M_p M_pᵀ = I.
/// M_pᵀ takes a parameter step to the tangent frame. Where p_u vanishes the first axis of the
/// frame is along p_v: l11 = l22 = 0, l21 = |p_v|.
struct FirstFormFactor {
  double l11 = kUnset;
  double l21 = kUnset;
  double l22 = kUnset;
};

}  // namespace surfmesh
