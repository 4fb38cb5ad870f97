// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "surfmesh/patch_mesh/triangulated_patch.hh"

namespace surfmesh {

/// True if the triangle's normal points against the sum of the surface's normals at its vertices,
/// or if it has no area.
/// Pre      evaluate_vertices has been called
bool is_turned(const TriangulatedPatch& patch, FaceHandle fh);

/// The middle of a turned triangle.
struct TurnedPlace {
  Uv uv;
  Vec3 point;
  /// True if the surface itself turns over there, or has no tangent plane: its normals at the
  /// corners point away from each other, or one has none.
  bool is_of_surface = false;
};

/// The triangles of a patch that look away from the normal of its surface.
struct TurnedTriangles {
  std::size_t count = 0;  ///< those of fans around poles among them
  /// One of them, where the surface turns over if there is such a one; unset if only fans have any.
  std::optional<TurnedPlace> place;
};

/// Find the turned triangles of a patch.
/// Pre      evaluate_vertices has been called
TurnedTriangles find_turned_triangles(const TriangulatedPatch& patch);

/// Fix triangles that are valid in (u,v) but turned against the surface in space, as happens where
/// elements are large for its curvature: swap an edge if that fixes both triangles, otherwise split
/// the longest chord in the middle. Repeat for a few rounds.
///
/// Writes   surf:uv, surf:metric of new vertices; points and normals of the patch
/// Some may stay turned: those at a contour whose own segments are too long.
/// Returns  those that are turned at the end
/// Cost     O(faces) if none is turned
TurnedTriangles mend_turned_triangles(TriangulatedPatch& patch);

}  // namespace surfmesh
