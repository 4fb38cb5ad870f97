// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// Sizes along a contour that is shorter than hmax: the length of the contour, in all directions.
/// Empty for a longer contour.
///
/// Without gradation, they hold within half of that length around the contour.
/// Cost     40 evaluations of the curve for a simple one
std::vector<PlacedSize> feature_sizes(const SpaceCurve& curve, const ResolvedSizing& sizing);

}  // namespace surfmesh
