// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/run_context.hh"
#include "surfmesh/core/stage.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"
#include "surfmesh/quad/quad_options.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {

/// Everything that determines the mesh of one patch. The surface and the field must outlive the
/// call.
struct PatchTask {
  const Surface& surface;
  const MetricField& field;
  PatchBoundary boundary;
  RefineOptions refine = {};
  ImproveOptions improve = {};
  /// Triangles farther than this from the surface are corrected one by one, model units; 0 is off.
  double corrected_sag = 0;
  /// Greatest ratio of the two sizes that was asked for. Beyond twice, corrections take triangles
  /// that are stretched as the metric is.
  double stretch = 1;
  QuadOptions quads = {};
};

/// The mesh of one patch, and the time and queries it took.
struct PatchResult {
  PatchMesh mesh;
  TurnedTriangles turned;    ///< that face against the normal of the surface
  bool is_given_up = false;  ///< see RefineReport::is_stopped
  RefineCounts refine;       ///< of triangles
  PerStage<double> seconds;
  PerStage<QueryCounts> queries;
};

/// Mesh one patch between the nodes of its boundary: boundary triangulation, inner nodes,
/// improvement, corrections.
///
/// Depends only on its arguments, so patches can be meshed anywhere and in any order.
///
/// Cost     about 1.5 µs per triangle
/// Throws   Geometry, InvalidOption; Limit and Cancelled by the context
/// Source   paper, section 2.1
PatchResult mesh_patch(PatchTask task, const RunContext& context = RunContext());

}  // namespace surfmesh
