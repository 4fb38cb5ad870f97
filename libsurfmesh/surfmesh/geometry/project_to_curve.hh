// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Find the point of a curve on a surface that is nearest to a point in space.
///
/// A point on the curve is found by Newton's method from `t_guess`. If the curve passes through it
/// several times (the two ends of a closed curve), the guess decides which t is found. For every
/// other point, 33 samples are compared and the neighbourhood of the nearest is searched. `t_guess`
/// may be any number; it is brought into [0,1].
///
/// Returns  t in [0,1]
/// Error    for a point on the curve, the distance to it is a few roundings of its coordinates
///          (test ProjectToCurve.FindsPointsOnTheCurve); for a point at distance d, the derivative
///          of the distance is zero to 1e-8 d for curves of unit third derivative, as a curve's
///          tangent is taken by differences (test ProjectToCurve.IsNearestFromAside). A curve that
///          comes near the point only between two of the 33 samples may be misjudged
/// Cost     on the curve with a fair guess 3 to 6 evaluations of first order, else about 40 to 140
double project_to_curve(const Surface& surface, const Curve& curve, const Vec3& point,
                        double t_guess);

}  // namespace surfmesh
