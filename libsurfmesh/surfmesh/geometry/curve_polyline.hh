// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"

namespace surfmesh {

/// A point of a curve in space.
struct CurvePoint {
  double t = kUnset;
  Vec3 point = Vec3::Constant(kUnset);
};

/// Points on a curve, both ends included, whose chords stay near it.
///
/// Intervals are halved until the curve at a quarter, the middle and three quarters of each is
/// within the tolerance of the chord, or the interval is 2^-12 of a part of the curve.
///
/// Units    tolerance in model units, above 0
/// Error    a bend between the samples of a part that is straight at 33 of them is not seen
/// Cost     five evaluations a chord
std::vector<CurvePoint> curve_polyline(const SpaceCurve& curve, double tolerance);

/// Share of the way from a to b at which the segment is nearest to p; 0 for a segment of no length.
inline double nearest_share(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 step = b - a;
  const double squared = step.squaredNorm();
  return squared > 0 ? std::clamp(step.dot(p - a) / squared, 0.0, 1.0) : 0;
}

/// Length of the chords.
double length(const std::vector<CurvePoint>& polyline);

}  // namespace surfmesh
