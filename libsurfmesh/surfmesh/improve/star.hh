// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/delaunay/metric_swaps.hh"

namespace surfmesh {

/// The triangles around an inner vertex, as the ring of its neighbours counter-clockwise.
class Star {
 public:
  /// Collect the ring; false for a vertex of the boundary.
  bool collect(const DelaunayMesh& delaunay, VertexHandle vh);

  const std::vector<MetricCorner>& ring() const { return ring_; }

  /// True if no triangle is inverted with the vertex at p, by exact orientation.
  bool sees(Uv p) const;

  /// Let the ring begin at the worst triangle with the vertex at p, so that quality() soon falls to
  /// its bound.
  void begin_at_worst(const MetricCorner& p);

  /// Least quality of the triangles if the vertex is at p; negative if one of them is inverted,
  /// by exact orientation. If that is no more than `enough`, any value up to there may be the
  /// result: the triangles after the first such one are not looked at.
  double quality(const MetricCorner& p, double enough = -1) const;

 private:
  std::vector<MetricCorner> ring_;
};

}  // namespace surfmesh
