// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// The curvature of a curve in space at t: that of the circle through three of its points.
///
/// The outer two points are 1/512 of a part of the curve away (at the ends, the circle is that of
/// the nearest t where they fit). With nearer points, errors of the positions would dominate: for a
/// curve of length L found by projection they are about 1e-12 L, which gives 1e-6 / L in the
/// curvature.
///
/// A corner has no curvature: there it is that of the straighter side. What turns within 1/2048 of
/// a part is a corner, not a bend.
///
/// Units    1/length; 0 if the three points coincide
/// Error    (κ'' + 2 κ' v'/v) / 12 times the square of the step of length, for speed v (test
///          ContourCurvature.IsThatOfACurve)
double curve_curvature(const SpaceCurve& curve, double t);

/// Sizes along a contour that follow from its curvature (CurvatureLength): that length along the
/// tangent and twice that length across, both clamped.
///
/// The contour is divided into segments on which the sizes change linearly. Segments are halved
/// until the size in the middle of each is within a tenth of the mean and the chord is within a
/// tenth of the size from the curve, but not below 2^-10 of a part of the contour. Segments without
/// a size below hmax are left out. Without gradation, sizes hold within half of their length, so
/// that at least one element has them.
///
/// Cost     40 evaluations of the curve for a simple one
std::vector<PlacedSize> contour_curvature_sizes(const SpaceCurve& curve,
                                                const ResolvedSizing& sizing);

}  // namespace surfmesh
