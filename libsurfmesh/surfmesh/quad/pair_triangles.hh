// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

/// Merge triangles in pairs, the best quads first, down to a least scaled Jacobian of 0.3.
///
/// Reads    surf:uv, surf:metric (vertex)
/// Returns  the number of triangles left
/// Cost     O(n log n)
/// Throws   Cancelled
std::size_t pair_triangles(PolyMesh& mesh, FaceEditor& editor, const RunContext& context);

/// Walk the triangles that are left to each other, two by two, and merge them.
///
/// The nearest two are found breadth first over the sides of faces. A triangle passes through a
/// quad as the two are cut anew into a quad and a triangle at the next side, by the better of the
/// two ways. The quads it leaves behind are of any shape, even inverted; cleaning mends them.
///
/// Returns  the number of triangles left: one at most, if their number is odd
/// Cost     O(faces nearer than the other triangle)
/// Throws   Cancelled
std::size_t walk_triangles(PolyMesh& mesh, FaceEditor& editor, const QuadGeometry& geometry,
                           const RunContext& context);

}  // namespace surfmesh
