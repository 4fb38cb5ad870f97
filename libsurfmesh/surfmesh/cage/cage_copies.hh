// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace surfmesh {

/// Find faces that are given more than once: the same vertices in the same circle, from any of them
/// on.
///
/// Of those in the same direction all but one are copies. One in the other direction is a copy if
/// otherwise an edge would have an odd number of three faces or more; two faces back to back, whose
/// edges have two or four, make a closed surface. The face that is kept agrees with the direction
/// of its neighbours as well as any, and is the first of these.
/// Returns  for each face the face that is kept in its place, itself if it is no copy
/// Cost     O(n log n) for n face corners
std::vector<int> find_copies(const std::vector<std::vector<int>>& faces);

}  // namespace surfmesh
