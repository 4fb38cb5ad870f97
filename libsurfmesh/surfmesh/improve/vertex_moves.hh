// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/improve/improve.hh"
#include "surfmesh/improve/star.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// While the least quality around them is above this, vertices may lose quality in favour of edge
/// lengths.
inline constexpr double kGoodQuality = 0.8;

/// Moves single inner vertices of a mesh; those of the boundary stay.
///
/// No triangle is ever inverted, and a moved vertex gets the metric of its new position.
class VertexMoves {
 public:
  VertexMoves(DelaunayMesh& delaunay, const MetricField& field)
      : delaunay_(delaunay), field_(field) {}

  /// Move a vertex to a better place, or half the way there, if the worst of its triangles does not
  /// become worse or stays good. A step below a hundredth of a unit is not worth its metric query.
  ///
  /// Best: a Gauss-Newton step for Σ (l − 1)² over its edges. Laplace: to the mean of its
  /// neighbours, weighted by their lengths l in the metric at the vertex; without weights, no
  /// metric would matter. Element: to the mean of the apexes that the triangles around would have
  /// if their other sides were of unit length, each in the metric at the middle of the triangle.
  /// Returns  whether it was moved
  /// Pre      the kind is not Off
  bool smooth(VertexHandle vh, Smoothing kind);

  /// Search for a better position for the vertex of a bad triangle, in eight directions, with steps
  /// from 0.2 to 0.02 units. The best one has the greatest score: the least quality minus half the
  /// excess of edges over the unit range.
  void search(VertexHandle vh);

  MetricCorner at(Uv p) { return {p, field_.at(p, hint_)}; }

  std::size_t count() const { return count_; }  ///< of moves so far
  const QueryCounts& queries() const { return hint_.answers; }

 private:
  void move(VertexHandle vh, const MetricCorner& p);
  Uv smoothing_step(const MetricCorner& centre, Smoothing kind);
  Uv spring_step(const MetricCorner& centre) const;
  Uv laplace_step(const MetricCorner& centre) const;
  Uv element_step(const MetricCorner& centre);
  double score(const MetricCorner& p, double enough) const;
  MetricCorner best_around(const MetricCorner& from, double step, double& best_score);

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  QueryHint hint_;
  Star star_;
  std::size_t count_ = 0;
};

}  // namespace surfmesh
