// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {

/// A contour as far as the search for near misses needs it.
struct ContourShape {
  int contour = -1;  ///< index in the model
  std::string name;
  SampledLine curve;
  bool is_shared = false;  ///< has several uses
};

/// Tell of contours that run along each other and yet are not one.
///
/// A quarter of one has to be within JoinLengths::near of the other, and farther than
/// JoinLengths::join somewhere. The stretch has to be some times longer than the gap, so that small
/// contours are not taken for near misses of their neighbours. Pairs that are both shared have
/// found their partners and are left out, as are the two sides of a narrow patch.
///
/// Returns  a shortfall a pair, with the names, the greatest gap in model units, and if one runs
///          along the other all the way, the joining that joins them; the last one counts the pairs
///          beyond twenty
/// Cost     O(n log n) for n contours that are short against the model
Notices near_miss_notices(const std::vector<ContourShape>& contours, const JoinLengths& lengths);

}  // namespace surfmesh
