// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// How the faces of a mesh turn, apart from its features.
struct MeshTurns {
  /// Median of the angles at which faces meet, where that is less than kFeatureAngle, degrees; 0 if
  /// there is no such edge.
  double median = 0;
  /// Share of the inner vertices at which the mesh turns to and fro by more than kNoisyAngle.
  double noisy_share = 0;
  /// Median of the distances of these vertices from where the mesh around would have them, shares
  /// of the lengths of their edges.
  double roughness = 0;
  double length = 0;  ///< mean of those of the edges, model units
};

/// Measure how the faces of a mesh turn.
///
/// The height of a vertex is that of its neighbours' mean above it, along its normal. On a smooth
/// surface heights of neighbours are alike; how far one differs from the mean of those around it is
/// noise, or a feature: a mesh is noisy if many do.
/// Units    degrees and shares
/// Cost     O(n log n) for n face corners
MeshTurns measure_turns(const Cage& cage);

/// A mesh is noisy if at more than this share of its vertices it turns to and fro.
inline constexpr double kNoisyShare = 0.4;

}  // namespace surfmesh
