// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/curvature.hh"

#include <Eigen/Geometry>
#include <cmath>

#include "surfmesh/geometry/first_form.hh"

namespace surfmesh {

// The shape operator in the orthonormal frame is S = L⁻¹ II L⁻ᵀ with I = L Lᵀ: symmetric, so that
// its eigenvectors are orthogonal to the last bit and the half-difference form loses no digits
// where the curvatures are nearly equal. The shape operator I⁻¹ II in (u,v) has neither property.
PrincipalCurvatures principal_curvatures(const Jet& jet) {
  const FirstFormFactor p = first_form_factor(jet.du, jet.dv);
  if (!is_regular(p)) return {};
  const Vec3 normal = jet.du.cross(jet.dv) / (p.l11 * p.l22);

  // L⁻¹ II, then times L⁻ᵀ.
  const double m = jet.duv.dot(normal);
  const double a11 = jet.duu.dot(normal) / p.l11;
  const double a12 = m / p.l11;
  const double a21 = (m - p.l21 * a11) / p.l22;
  const double a22 = (jet.dvv.dot(normal) - p.l21 * a12) / p.l22;
  const double s11 = a11 / p.l11;
  const double s12 = a21 / p.l11;
  const double s22 = (a22 - p.l21 * s12) / p.l22;

  const double mean = 0.5 * (s11 + s22);
  const double half = 0.5 * (s11 - s22);
  const double radius = std::sqrt(half * half + s12 * s12);
  if (radius == 0) return {mean, mean, 1, 0};
  return {mean + radius, mean - radius, half / radius, s12 / radius};
}

}  // namespace surfmesh
