// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/improve/star.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Σ 1 / quality over the triangles between a vertex and the ring of its neighbours; infinite if
/// one of them is inverted, by exact orientation.
double sum_of_inverse_qualities(const Star& star, const MetricCorner& centre);

/// The Newton step of a vertex towards the least Σ 1 / quality.
///
/// While the metric of each triangle is held, 1 / quality is a quadratic function of the place of
/// the vertex over a linear one. That is convex, so the step leads downwards.
Uv shape_step(const Star& star, const MetricCorner& centre);

/// Finds places of single inner vertices at which the triangles around have better shapes in the
/// metric. Unlike VertexMoves it takes no notice of the lengths of edges.
class ShapeMoves {
 public:
  ShapeMoves(DelaunayMesh& delaunay, const MetricField& field)
      : delaunay_(delaunay), field_(field) {}

  /// Move a vertex by a Newton step, or half of it, if that lowers Σ 1 / quality and
  /// `may_be_at(uv)`. It stays where all its triangles are above the quality `good`, and where the
  /// step is below a hundredth of a unit.
  ///
  /// Returns  whether it was moved
  template <class MayBeAt>
  bool smooth(VertexHandle vh, double good, MayBeAt may_be_at);

 private:
  static constexpr double kLeastMove = 0.01;

  DelaunayMesh& delaunay_;
  const MetricField& field_;
  QueryHint hint_;
  Star star_;
};

/// Move all inner vertices so, and swap edges.
///
/// Reads    surf:uv, surf:metric, surf:constrained
/// Writes   surf:uv, surf:metric of inner vertices
/// Cost     0.5 µs per vertex, and swap_edges
/// Throws   Cancelled
void smooth_shapes(DelaunayMesh& delaunay, const MetricField& field,
                   const RunContext& context = RunContext());

template <class MayBeAt>
bool ShapeMoves::smooth(VertexHandle vh, double good, MayBeAt may_be_at) {
  if (!star_.collect(delaunay_, vh)) return false;
  const MetricCorner old = corner(delaunay_, vh);
  if (star_.quality(old, good) > good) return false;
  Uv step = shape_step(star_, old);
  const double length = std::sqrt(squared_length(old.metric, step));
  if (!(length >= kLeastMove && length < INFINITY)) return false;
  const double before = sum_of_inverse_qualities(star_, old);
  for (int attempt = 0; attempt < 2; ++attempt, step = 0.5 * step) {
    const Uv uv = old.uv + step;
    // Far moves that invert a triangle are not worth a query.
    if (!star_.sees(uv)) continue;
    const MetricCorner there{uv, field_.at(uv, hint_)};
    if (sum_of_inverse_qualities(star_, there) >= before || !may_be_at(uv)) continue;
    delaunay_.uv(vh) = there.uv;
    delaunay_.metric(vh) = there.metric;
    return true;
  }
  return false;
}

}  // namespace surfmesh
