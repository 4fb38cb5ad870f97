// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/improve/vertex_moves.hh"

namespace surfmesh {

/// Smooth all inner vertices in the order of their numbers, several times.
///
/// A vertex that was left where it was is quiet until one of its neighbours moves: it would be left
/// there again, so it is passed over.
///
/// Writes   surf:uv, surf:metric of moved vertices
/// Returns  how often a vertex was looked at
/// Cost     a smoothing step for each of these
/// Throws   Cancelled
/// Pre      the kind is not Off
std::size_t smooth_sweeps(DelaunayMesh& delaunay, VertexMoves& moves, Smoothing kind, int sweeps,
                          const RunContext& context = RunContext());

}  // namespace surfmesh
