// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Where an interpolating surface turns more than the faces.
struct SurfaceWaves {
  std::size_t edges = 0;               ///< of two measured faces, that are no creases
  std::size_t waves = 0;               ///< of those: where the surface turns more than the faces
  double greatest = 0;                 ///< of the waves, degrees
  Vec3 point = Vec3::Zero();           ///< where that is
  std::vector<int> folded_faces = {};  ///< beside folds, ascending
};

/// Compare the normals of the limit surface of a cage in the middle of edges with those of the
/// faces of the mesh that it interpolates.
///
/// The normal in the middle of an edge is expected between those of its two faces. It is a wave if
/// it is beyond them by more than 6 degrees, and by more than the greatest angle at which one of
/// these faces meets another one; from 45 degrees on it is a fold. Edges that are creases, and
/// borders, are left out. A fold is also where a quarter of the surface over a face turns away from
/// the face by more than 60 degrees, and by more than the greatest angle at which the face meets
/// another one.
///
/// Faces without a surface, such as holes, and those at a vertex with a semi-sharp tag of more than
/// 1 are left out: normals there are not known after one step of subdivision.
/// Units    degrees and model units
/// Pre      the cage has the faces of the mesh
/// Throws   InvalidInput for a cage that cannot be subdivided by the scheme
/// Cost     O(face corners), 3 µs a face
SurfaceWaves measure_waves(const Cage& mesh, const Cage& cage, Scheme scheme);

}  // namespace surfmesh
