// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/graded_sizes.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh::judge {

struct JudgeOptions {
  double nodes = 40'000;     ///< of the grid of each patch, about
  bool is_adaptive = false;  ///< refine the grids of patches whose counts have not settled
  double most_nodes = 2e6;   ///< of all grids together
};

/// A mesh against the exact sizes of its model.
struct Judgement {
  std::size_t triangles = 0;  ///< a polygon counts as those it can be cut into
  double ideal = 0;           ///< unit triangles that fill the metric area
  double coarse_ideal = 0;    ///< the same on grids of a quarter of the nodes
  std::size_t nodes = 0;      ///< of all grids
  bool is_bounded = false;    ///< true if there would be more nodes without the bound
  EdgeStatistics edges;

  /// True if the ideal count no longer depends on the grids, within 1 %.
  bool is_settled() const;
};

/// Judge a mesh with surf:uv and surf:patch. Its metric becomes the exact one.
///
/// The metric area of a patch without trims is that of its whole domain; of a trimmed patch, that
/// of the triangles of the mesh.
/// Writes   surf:metric (halfedge)
/// Throws   MissingProperty; InvalidInput if a corner is not where the model has its (u,v)
Judgement judge_mesh(PolyMesh& mesh, const ModelInput& input, const JudgeOptions& options);

}  // namespace surfmesh::judge
