// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Two uses of a contour whose patches are joined there.
using UsePair = std::array<int, 2>;

/// The pairs of uses along which patches are joined, by contour.
///
/// Two uses are one pair. Where more patches of one solid meet, those are pairs that have the
/// material of the solid between them: two wedges that touch along an edge stay apart. There are no
/// pairs at true boundaries, at poles, and where more than two patches meet that are not of one
/// solid (Patch::solid), or whose sides do not alternate between material and air.
///
/// Cost     O(contours); for those of more than two uses one evaluation of each, and a projection
std::vector<std::vector<UsePair>> joined_uses(const Model& model);

}  // namespace surfmesh
