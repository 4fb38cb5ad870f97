// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// A vertex at which the mesh turns by more than this, seen from its neighbours, and these do not,
/// is noise or a feature, degrees.
inline constexpr double kNoisyAngle = 10;

/// How the faces of a mesh turn, apart from its features.
struct MeshTurns {
  /// Median of the angles at which faces meet, where that is less than kFeatureAngle, degrees; of
  /// all where most are not. 0 without edges of two faces.
  double median = 0;
  double paired_share = 0;  ///< share of the edges that have two faces
  /// Share of the inner vertices at which the mesh zigzags by more than kNoisyAngle.
  double noisy_share = 0;
  /// Median of the distances of these vertices from where the mesh around would have them, shares
  /// of the lengths of their edges.
  double roughness = 0;
  double length = 0;        ///< mean of those of the edges, model units
  std::size_t spikes = 0;   ///< vertices that stand out of a mesh which goes on beside them
  int spike = -1;           ///< the one that stands out farthest, -1 for none
  double spike_height = 0;  ///< by which it does, a share of the length of its edges
};

/// Measure how the faces of a mesh turn.
///
/// The height of a vertex is that of its neighbours' mean above it, along its normal. On a smooth
/// surface heights of neighbours are alike; how far one differs from the mean of those around it is
/// noise, or a feature: a mesh is noisy if many do. Borders, also those of holes, count for
/// nothing. A spike is a vertex that is moved by more than
/// 0.17 of the length of its edges: so that without the move heights around would be alike, to 0.4
/// of it.
/// Units    degrees and shares
/// Cost     O(n log n) for n face corners, 1 µs a face
MeshTurns measure_turns(const Cage& cage);

/// A mesh is noisy if it zigzags at more than this share of its inner vertices.
inline constexpr double kNoisyShare = 0.4;

}  // namespace surfmesh
