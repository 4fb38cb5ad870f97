// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/run_context.hh"
#include "surfmesh/patch_mesh/triangulated_patch.hh"

namespace surfmesh::detail {

/// Move inner nodes and swap edges for better shapes, first in the metric, then of the worst
/// triangles in space, where all triangles that change are within `aim` of the surface then.
///
/// Reads    surf:uv, surf:metric, surf:constrained
/// Writes   surf:uv, surf:metric of moved vertices; points and normals of the patch
/// Error    that of SagMeter
/// Cost     about 50 surface evaluations for a node with triangles of poor shape
/// Pre      evaluate_vertices has been called; the mesh of the patch is shrunk
/// Throws   Cancelled
void smooth_within_sag(TriangulatedPatch& patch, double aim,
                       const RunContext& context = RunContext());

}  // namespace surfmesh::detail
