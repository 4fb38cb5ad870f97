// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// The curvature of a curve in space at t, that of the circle through three of its points.
///
/// The outer two are 1/512 of a part of the curve away (at the ends the circle is that of the
/// nearest place where they fit): nearer ones would be lost in the errors of the positions, which
/// for a curve of length L found by projection are near 1e-12 L, and in the curvature 1e-6 / L.
///
/// Units    1/length; 0 where the three points are one
/// Error    (κ'' + 2 κ' v'/v) / 12 times the square of the step of length, for speed v (test
///          ContourCurvature.IsThatOfACurve)
double curve_curvature(const SpaceCurve& curve, double t);

/// Sizes along a contour that follow from its curvature (CurvatureLength): along the tangent the
/// length it asks for, across twice that, both clamped.
///
/// The contour becomes segments on which the sizes change linearly; they are halved until the size
/// in the middle of each is within a tenth of the mean and the chord within a tenth of the size of
/// the curve, or 2^-10 of a part of the contour. Segments that want no size below hmax are left
/// out. Without gradation sizes hold within half of their length, so that there is an element with
/// them.
///
/// Cost     40 evaluations of the curve for a simple one
std::vector<PlacedSize> contour_curvature_sizes(const SpaceCurve& curve,
                                                const ResolvedSizing& sizing);

}  // namespace surfmesh
