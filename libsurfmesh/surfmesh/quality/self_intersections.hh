// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/quality/face_set_check.hh"

namespace surfmesh {

/// True if two triangles pass through each other: they have a piece of a line in common that is
/// inside one of them at least, or, in one plane, a piece of area.
///
/// Triangles that only touch, in a point or along a piece of their sides, do not: so neighbours
/// need no mention, even where they have vertices of their own. Those with a vertex or a side in
/// common may pass through each other elsewhere. Exact; a triangle without area meets none.
bool pass_through(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// Find the pairs of faces that pass through each other, and tell the first ones:
/// "self_intersection".
///
/// Faces of more than three corners are split into the fan of their first corner. Runs on the
/// threads of with_threads; the result does not depend on their number.
///
/// Cost     O(n log n) for n triangles of which few boxes overlap, 1 µs a triangle; O(n²) where all
///          do, as in a fan of slivers
/// Throws   Cancelled
MeshFault find_self_intersections(const MeshArrays& set, const RunContext& context = RunContext());

}  // namespace surfmesh
