// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/across/vertex_chart.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// The triangles around an inner vertex, as the ring of its neighbours counter-clockwise.
class SpaceStar {
 public:
  /// `charts` are those of the vertices; they may grow, but must outlive this.
  explicit SpaceStar(const std::vector<VertexChart>& charts) : charts_(charts) {}

  /// Collect the ring.
  /// Returns  false for a vertex of the border
  bool collect(const PolyMesh& mesh, VertexHandle vh);

  const std::vector<VertexHandle>& ring() const { return ring_; }

  /// True if no triangle is turned against the normal of a chart with the vertex at a point.
  bool sees(const VertexChart& centre, const Vec3& point) const;

  /// Least quality of the triangles with a chart in the place of the vertex. If that is no more
  /// than `enough`, any value up to there may be the result.
  double quality(const VertexChart& centre, double enough = -1) const;

  /// Least quality less half the excess of the edges over the unit range; likewise.
  double score(const VertexChart& centre, double enough) const;

  /// A Gauss-Newton step for Σ (l − 1)² over the edges.
  ChartStep spring_step(const VertexChart& centre) const;

 private:
  const VertexChart& chart(VertexHandle vh) const { return charts_[index(vh)]; }

  const std::vector<VertexChart>& charts_;
  std::vector<VertexHandle> ring_;
};

}  // namespace surfmesh
