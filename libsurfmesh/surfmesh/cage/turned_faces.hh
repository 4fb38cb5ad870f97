// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace surfmesh {

/// Find faces that are turned against most of those they are connected with.
///
/// Two faces agree if they pass their common edge in opposite directions; edges of more than two
/// faces do not connect. Where the sides of a connected set of faces cannot be told apart (a Möbius
/// band), none of its faces is turned. Of two halves of the same size, that of the first face
/// counts as right.
/// Returns  for each face whether it is turned
/// Cost     O(n log n) for n face corners
std::vector<char> turned_faces(const std::vector<std::vector<int>>& faces);

}  // namespace surfmesh
