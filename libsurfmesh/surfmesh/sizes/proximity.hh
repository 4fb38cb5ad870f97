// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/placed_size.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// Sizes between parts of the boundary that face each other across a patch, or across several
/// patches that smooth contours join. Returned by patch: the sizes of a gap belong to the patches
/// at both of its ends.
///
/// Contours that are not smooth are divided into pieces. From the middle of each piece, the nearest
/// point of another piece is searched that lies within 60° of the inward directions of both and
/// whose inward direction is opposite (beyond 120°). Its distance is the gap, across which
/// ResolvedSizing::proximity rows of unit triangles are to fit: a segment across has the size
/// gap / (proximity √3/2) along itself and twice that in the other direction. Pieces are halved
/// until they are no longer than twice their gap, or twice the gap that asks for hmin. Two pieces
/// of one contour, or of contours that end at the same vertex, count only if the way along them is
/// more than six times the gap. Corners down to 20° and round ends are therefore no gaps.
///
/// Units    gaps are measured in space
/// Error    a gap is within 5 %, whatever hmax (test
///          Proximity.IsTheWidthOfACurvedStripWhateverHmax)
/// Cost     O(n log n) for n pieces of the boundary, and for each those that are nearer than its
///          gap. Without a gap, those within reach: O(n²) if all are and none face each other
std::vector<std::vector<PlacedSize>> proximity_sizes(const Model& model,
                                                     const ResolvedSizing& sizing);

}  // namespace surfmesh
