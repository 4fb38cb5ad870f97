// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/improve/vertex_moves.hh"

namespace surfmesh {

/// What fit_lengths changed.
struct FitReport {
  std::size_t collapsed = 0;  ///< edges
  std::size_t split = 0;      ///< edges
};

/// Collapse inner edges shorter than 1/√2, split those longer than √2, and smooth around both.
///
/// A collapse merges an inner vertex into its neighbour. Either is done only if no triangle is
/// inverted, the worst one does not become worse or stays good, and no new edge leaves the unit
/// range at the other end.
///
/// Writes   surf:uv, surf:metric; the last elements take over the numbers of removed ones, vertices
///          before the first inner one keep theirs
/// Cost     the length of every edge, and up to nine moves per change
/// Throws   Cancelled
FitReport fit_lengths(DelaunayMesh& delaunay, VertexMoves& moves,
                      const RunContext& context = RunContext());

}  // namespace surfmesh
