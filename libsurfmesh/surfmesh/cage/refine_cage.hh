// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// Which quarter of a polygon a face is.
struct QuarterOfFace {
  int part = -1;     ///< the corner of the polygon; -1 for the whole of it
  int rotation = 0;  ///< the corner of the face that is this corner
  int corners = 0;   ///< of the polygon, without sides that are points
};

/// A cage made from another one, and where its faces come from.
struct RefinedCage {
  Cage cage;
  std::vector<int>
      parent_faces;  ///< for each new face, the face of the original cage it is part of
  std::vector<QuarterOfFace> quarters;  ///< for each new face
  bool is_refined = false;  ///< false if the faces are those of the original cage, not parts
  Notices notices;          ///< tags that make no sense and were ignored
};

/// Subdivide a cage once, which does not change its limit surface.
///
/// Creases and corners are as OpenSubdiv has them after one step: semi-sharp ones lose 1, and true
/// boundaries and, depending on the boundary rule, their corners become infinitely sharp. Holes and
/// groups follow from the parents of faces. The parts of a face are in the order of its corners.
/// Error    rounding of the new points
/// Cost     O(face corners)
/// Throws   InvalidInput if the cage cannot be subdivided by the scheme, or a side is a point
RefinedCage refine_once(const Cage& cage, Scheme scheme);

/// Give a cage the faces that limit surfaces need: quads, or triangles for Loop.
///
/// Faces that are not simple are left out, with a warning. If a face of a Catmull-Clark or bilinear
/// cage is then not a quad, the cage is refined once. Before that, sides that are points (the same
/// vertex twice in a row) are removed from their faces, with a warning: their parts would make
/// OpenSubdiv's Bfr 3.5.0 read memory out of bounds. They are removed for Loop as well, which
/// accepts triangles only; Catmull-Clark and bilinear cages of quads keep such sides.
/// Throws   InvalidInput if the cage cannot be subdivided by the scheme
RefinedCage make_regular(const Cage& cage, Scheme scheme);

/// The same for a cage from which faces were left out. `numbers` has for each face the number that
/// it has in messages and in `parent_faces`: that of the original cage.
RefinedCage make_regular(const Cage& cage, Scheme scheme, const std::vector<int>& numbers);

/// The cage that make_regular subdivides, or keeps, without the faces and sides that it leaves out.
///
/// Pre      scheme is not Auto
/// Throws   InvalidInput if no face is left, or one is no triangle under Loop
RefinedCage make_simple(const Cage& cage, Scheme scheme, const std::vector<int>& numbers);

}  // namespace surfmesh
