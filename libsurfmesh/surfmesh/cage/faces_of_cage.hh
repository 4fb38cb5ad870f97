// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage_surface.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/cage/refine_cage.hh"

namespace surfmesh {

/// For each face of a mended and refined cage, what it is of the cage as given.
///
/// Cost     O(face corners)
std::vector<FaceOfCage> faces_of_cage(const Cage& cage, const MendedCage& mended,
                                      const RefinedCage& regular);

}  // namespace surfmesh
