// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Principal curvatures, k1 ≥ k2, and the direction of k1. All NaN where there is no tangent plane.
///
/// The direction is an angle in the frame of FirstFormFactor, from p_u towards p_v; k2 lies across.
/// Stored are the cosine and sine of twice the angle, which is all that tensors need.
///
/// Units    curvatures 1/length, positive where the surface bends towards the normal p_u × p_v
struct PrincipalCurvatures {
  double k1 = kUnset;
  double k2 = kUnset;
  double cos2 = kUnset;
  double sin2 = kUnset;

  /// Radians in [−π/2, π/2].
  double angle() const { return 0.5 * std::atan2(sin2, cos2); }
};

/// Compute the principal curvatures from a jet of order Second.
///
/// At an umbilic k1 = k2 and the angle is arbitrary but finite. Where p_u or p_v vanishes or they
/// are parallel (is_regular of their first form is false) the result is NaN.
///
/// Error    below 1e-14 of the greater curvature, divided by the square of the sine between p_u
///          and p_v (test Curvature.LosesDigitsByTheSquareOfTheSine)
PrincipalCurvatures principal_curvatures(const Jet& jet);

}  // namespace surfmesh
