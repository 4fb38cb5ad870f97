// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

/// Moves single vertices of a mesh of quads to where the energy of the corners around is less.
class QuadSmoother {
 public:
  explicit QuadSmoother(QuadGeometry& geometry) : geometry_(geometry) {}

  /// Move a vertex by a Newton step with the metrics held, at most 0.3 long, or a shorter one if
  /// that does not lower the energy.
  ///
  /// Returns  the metric length of the step; 0 if the vertex stays
  /// Cost     0.3 µs and a metric query
  double smooth(VertexHandle vh, EnergyWeights weights);

 private:
  QuadGeometry& geometry_;
  std::vector<CornerTerms> star_;
};

/// What smoothing is for.
enum class SmoothingAim {
  Shape,         ///< sizes and shapes count alike
  BetterShape,   ///< shapes count more than sizes
  WorstCorners,  ///< of quads under 0.8 the worst corners; no step lowers the least around it
};

/// Smooth the vertices of a mesh of quads, at most `sweeps` times. After the first sweep, only
/// vertices beside one that has moved by more than 0.02 are looked at.
///
/// Vertices and faces that are not in use are passed over.
/// Cost     about 0.5 µs per vertex that moves, and its metric query
/// Throws   Cancelled
void smooth_quads(const PolyMesh& mesh, QuadGeometry& geometry, SmoothingAim aim, int sweeps,
                  const RunContext& context);

}  // namespace surfmesh
