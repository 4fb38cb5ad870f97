// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// A cage made of another one, and where its faces come from.
struct RefinedCage {
  Cage cage;
  std::vector<int> parent_faces;  ///< of each new face, the face of the cage that it is a part of
  bool is_refined = false;        ///< false if the faces are faces of the cage, not parts of them
  Notices notices;                ///< tags that make no sense and were ignored
};

/// Subdivide a cage once, which does not change its limit surface.
///
/// Creases and corners carry over as OpenSubdiv has them after one step (semi-sharp ones lose 1,
/// true boundaries and, by the boundary rule, their corners become infinitely sharp), holes and
/// groups by the parents of faces. The parts of a face are in the order of its corners.
/// Error    rounding of the new points
/// Cost     O(face corners)
/// Throws   InvalidInput if the cage cannot be subdivided by the scheme, or a side is a point
RefinedCage refine_once(const Cage& cage, Scheme scheme);

/// Bring a cage to faces of the size that limit surfaces are made of: quads, or triangles for Loop.
///
/// Faces that are not simple are left out, with a warning. If then a face of a Catmull-Clark or
/// bilinear cage is not a quad, the cage is refined once, and sides that are points (the same
/// vertex twice in a row) are left out of their faces before, with a warning: their parts would
/// make OpenSubdiv's Bfr 3.5.0 read memory that is not its own. They are left out for Loop, too,
/// which knows triangles only; Catmull-Clark and bilinear cages of quads keep such sides.
/// Throws   InvalidInput if the cage cannot be subdivided by the scheme
RefinedCage make_regular(const Cage& cage, Scheme scheme);

}  // namespace surfmesh
