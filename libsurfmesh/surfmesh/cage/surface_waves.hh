// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Where an interpolating surface turns more than the faces.
struct SurfaceWaves {
  std::size_t edges = 0;      ///< of two faces, that are no creases
  std::size_t waves = 0;      ///< of those: the surface turns more than kWaveAngle beyond the faces
  double greatest = 0;        ///< by which the surface turns more than the faces, degrees
  Vec3 point = Vec3::Zero();  ///< where
};

/// Compare the normals of the limit surface of a cage, in the middle of its faces and edges, with
/// those of the faces of the mesh that it interpolates.
///
/// The normal in the middle of an edge is expected between those of its two faces, and that of a
/// face near its own: no farther from the face's than the greatest angle between it and a face
/// beside it. What is more is a wave. Edges that are creases, and borders, are left out.
/// Pre      the cage has the faces of the mesh
/// Throws   InvalidInput for a cage that cannot be subdivided by the scheme
/// Cost     O(face corners), 3 µs a face
SurfaceWaves measure_waves(const Cage& mesh, const Cage& cage, Scheme scheme);

}  // namespace surfmesh
