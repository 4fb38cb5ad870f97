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

  /// Least quality of the triangles if the vertex is at p; negative if one of them is inverted,
  /// by exact orientation.
  double quality(const MetricCorner& p) const;

 private:
  std::vector<MetricCorner> ring_;
};

}  // namespace surfmesh
