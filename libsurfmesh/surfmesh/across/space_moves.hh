// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/across/space_star.hh"
#include "surfmesh/across/triangle_state.hh"

namespace surfmesh {

/// While the least quality around them is above this, vertices may lose quality in favour of edge
/// lengths, as within patches.
inline constexpr double kGoodSpaceQuality = 0.8;

/// Moves single inner vertices over the surface, as VertexMoves does within a patch; those of the
/// border stay. No triangle is ever inverted.
class SpaceMoves {
 public:
  explicit SpaceMoves(TriangleState& state) : state_(state), star_(state.charts) {}

  /// Move a vertex to where its edges have unit length, or half the way there, if the worst of its
  /// triangles does not become worse or stays good.
  /// Returns  whether it was moved
  bool smooth(VertexHandle vh);

  /// Search for a better place for the vertex of a bad triangle, in eight directions.
  void search(VertexHandle vh);

 private:
  VertexChart best_around(const VertexChart& from, double step, double& best_score);

  TriangleState& state_;
  SpaceStar star_;
};

}  // namespace surfmesh
