// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// The contours that elements need not follow, by contour 1 for such: those that merely divide a
/// smooth surface, between patches of the same groups, and that the user has not named.
///
/// Cost     O(contour uses × groups)
std::vector<char> dissolved_contours(const Model& model);

}  // namespace surfmesh
