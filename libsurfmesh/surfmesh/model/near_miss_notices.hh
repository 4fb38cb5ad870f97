// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/matched_sides.hh"

namespace surfmesh {

/// Tell of near misses, each with the joining that joins it.
///
/// That joining is found by trial on the patches around.
///
/// Returns  a shortfall a near miss, with the names, the gap, and the joining if one was found; the
///          last one counts those beyond twenty. Contours are the indices of curves
/// Cost     of find_near_misses, and for each of the twenty up to five times that of the search for
///          coincident sides on the patches around
Notices near_miss_notices(const MatchedSides& matched, const JoinLengths& lengths);

}  // namespace surfmesh
