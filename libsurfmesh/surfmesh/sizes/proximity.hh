// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// Sizes between parts of the boundary that face each other across a patch, or across several that
/// smooth contours join, by patch: those of a gap on the patches at both of its ends.
///
/// From the middle of each piece of a contour that is not smooth the nearest point of another piece
/// is looked for that lies inwards, within 60° of the inward direction of either, and whose inward
/// direction is against it (beyond 120°). Across its distance, the gap, ResolvedSizing::proximity
/// rows of unit triangles shall fit: a segment across wants the size gap / (proximity √3/2) along
/// itself and twice that the other way. Pieces are halved until they are no longer than twice their
/// gap, or twice a gap that wants hmin. Pieces of one contour, or of two that end at one vertex, do
/// not count unless the way along them is more than six times the gap: so corners down to 20° are
/// no gaps, nor are round ends.
///
/// Units    gaps are measured in space
/// Error    a gap is within a twentieth, whatever hmax (test
///          Proximity.IsTheWidthOfACurvedStripWhateverHmax)
/// Cost     O(n log n) for n pieces of the boundary, and for each those that are nearer than its
///          gap; without a gap, those within reach: O(n²) where all are and none face each other
std::vector<std::vector<PlacedSize>> proximity_sizes(const Model& model,
                                                     const ResolvedSizing& sizing);

}  // namespace surfmesh
