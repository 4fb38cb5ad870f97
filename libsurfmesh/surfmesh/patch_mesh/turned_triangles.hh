// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh {

/// True if the triangle's normal points against the sum of the surface's normals at its vertices.
/// Pre      evaluate_vertices has been called
bool is_turned(const PatchMesh& patch, FaceHandle fh);

/// Count the turned triangles of a patch, also those of its fans around poles.
/// Pre      evaluate_vertices has been called
std::size_t count_turned_triangles(const PatchMesh& patch);

/// The middle of a turned triangle of a patch; none if no triangle outside fans is turned.
/// Pre      evaluate_vertices has been called
std::optional<Vec3> find_turned_place(const PatchMesh& patch);

/// Fix triangles that are valid in (u,v) but turned against the surface in space, as happens where
/// elements are large for its curvature: swap an edge if that fixes both triangles, otherwise split
/// the longest chord in the middle. Repeat for a few rounds.
///
/// Writes   surf:uv, surf:metric of new vertices; points and normals of the patch
/// Some may stay turned: those at a contour whose own segments are too long.
/// Returns  how many are turned at the end, including those of fans around poles
/// Cost     O(faces) if none is turned
std::size_t mend_turned_triangles(PatchMesh& patch);

}  // namespace surfmesh
