// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/geometry/cage.hh"

namespace surfmesh {

/// A cage after one step of subdivision: all quads, or all triangles under Loop.
struct RefinedCage {
  Cage cage;
  std::vector<int> parent_faces;  ///< of each new face, the face of the cage that it is a part of
  std::vector<std::string> warnings;  ///< tags that make no sense and were ignored
};

/// Subdivide a cage once, which does not change its limit surface.
///
/// Creases and corners carry over as OpenSubdiv has them after one step (semi-sharp ones lose 1,
/// true boundaries and, by the boundary rule, their corners become infinitely sharp), holes and
/// groups by the parents of faces. The parts of a face are in the order of its corners.
/// Error    rounding of the new points
/// Cost     O(face corners)
/// Throws   InvalidInput if the cage cannot be subdivided by the scheme
RefinedCage refine_once(const Cage& cage, Scheme scheme);

}  // namespace surfmesh
