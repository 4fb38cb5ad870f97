// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A contour as places in the parameters of a patch that follow each other. They may lie beyond the
/// seam of a closed surface, or jump from one side of it to the other.
using UvPath = std::vector<Uv>;

/// The parameters of places along a curve in space that lies on a surface.
///
/// Cost     as find_near_points for each of 65 places
UvPath path_on(const Surface& surface, const SpaceCurve& curve);

/// True if the places of path_on are those of the curve, up to `reach` (model units).
bool lies_on(const Surface& surface, const SpaceCurve& curve, const UvPath& path, double reach);

/// Places along a curve in the parameters of a patch.
UvPath path_of(const Curve& curve);

/// Words that tell how to put the seam of a closed surface where no contour crosses it: another
/// domain of the same width. Nothing if no contour crosses the seam, if the surface is not closed
/// or has no values beyond its domain, or if contours leave no room for the seam.
///
/// Fixed contours are given in the parameters, and must lie inside the domain as they are.
/// Cost     O(n log n) for n contours, and some tens of evaluations
std::optional<std::string> free_seam_advice(const Surface& surface,
                                            const std::vector<UvPath>& contours, bool are_fixed);

}  // namespace surfmesh
