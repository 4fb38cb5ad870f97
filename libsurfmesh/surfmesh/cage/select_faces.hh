// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Make a cage of some faces of another one, in their order; points keep their numbers.
///
/// `stand_ins` has for each face the face that stands for it: itself if it is selected, another
/// one that is selected, in whose groups that one then is, or -1 if it is left out. Face numbers of
/// tags and groups that are out of range stay as they are, for others to warn of. Cost     O(face
/// corners)
Cage select_faces(const Cage& cage, const std::vector<int>& stand_ins);

/// The numbers of the faces that are selected.
std::vector<int> selected_faces(const std::vector<int>& stand_ins);

}  // namespace surfmesh
