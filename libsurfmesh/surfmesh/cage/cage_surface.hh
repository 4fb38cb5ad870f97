// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A place on a face of the cage that a surface was made from.
///
/// Corner i of the domain is vertex i of the face as given. The quarter of a polygon is a unit
/// square with its corner at (0,0), the middles of the sides after and before it at (1,0) and
/// (0,1), and the middle of the polygon at (1,1).
struct CagePlace {
  int face = -1;  ///< of the cage as given; -1 for a surface of no cage
  /// The corner of the face in whose quarter of a polygon it is; -1 for the whole face.
  int part = -1;
  Uv uv;  ///< in the domain of the face, or of its part
  /// Corners of the face without sides that are points, or were welded. Three of them without a
  /// part: the unit triangle.
  int corners = 0;
};

/// A surface made of faces of a cage.
class CageSurface : public Surface {
 public:
  /// The place on the cage of a point of the domain. On the border of two faces that of one of
  /// them.
  ///
  /// Cost     a few nanoseconds; of regions, that of an evaluation of first order
  virtual CagePlace place(Uv uv) const = 0;
};

/// The face of a cage, or the part of one, over which a surface lies, and how it lies there.
struct FaceOfCage {
  int face = -1;           ///< of the cage as given
  int part = -1;           ///< see CagePlace
  int corners = 0;         ///< see CagePlace
  int rotation = 0;        ///< the corner of the surface's domain at the corner of the part
  bool is_turned = false;  ///< the surface passes the corners of the face the other way around
};

/// Where a point of the domain of a surface lies on its face.
CagePlace place_on(const FaceOfCage& face, Uv uv);

/// The place on its cage of a point of a surface; one of no face for surfaces of no cage.
CagePlace cage_place(const Surface& surface, Uv uv);

}  // namespace surfmesh
