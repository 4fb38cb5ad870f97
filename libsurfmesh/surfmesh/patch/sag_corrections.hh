// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/patch_mesh/triangulated_patch.hh"

namespace surfmesh::detail {

/// What it took to bring a patch near enough to its surface.
struct SagCorrections {
  std::size_t swaps = 0;
  std::size_t nodes = 0;
};

/// Correct the triangles that are farther from the surface than `aim`.
///
/// Each such triangle gets the swap of an edge or the move of a node that is enough, else a node in
/// the middle of its longest inner edge, or on the ridge of a bend across an edge where no middle
/// helps, with swaps around for quality. Everything else stays as it
/// is: where sizes are made smaller instead, all triangles around are others, and some of these too
/// far again.
///
/// Reads    surf:uv, surf:metric, surf:constrained
/// Writes   surf:uv, surf:metric of new vertices; points and normals of the patch
/// Error    that of SagMeter
/// Cost     10 surface evaluations a triangle, some hundreds a triangle that is too far
/// Pre      evaluate_vertices has been called
/// Throws   Cancelled
SagCorrections correct_sag(TriangulatedPatch& patch, double aim,
                           const RunContext& context = RunContext());

}  // namespace surfmesh::detail
