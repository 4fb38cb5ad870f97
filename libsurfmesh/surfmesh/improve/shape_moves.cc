// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/shape_moves.hh"

#include <numbers>

#include "surfmesh/geometry/predicates.hh"

namespace surfmesh {
namespace {

/// Gradient and second derivatives of a sum of functions of (u,v).
struct Slopes {
  Uv first{0, 0};
  double uu = 0, uv = 0, vv = 0;
};

/// Add those of 1 / quality = S / (2√3 √det M · D) for the triangle of `p` and two neighbours, with
/// S = Σ l² and twice the area D in (u,v). With r = S / D, ∇r = (∇S − r ∇D) / D, and
/// ∂i∂j r = (∂i∂j S − ∂i r ∂j D − ∂j r ∂i D) / D, for D is linear.
void add_slopes(const MetricCorner& p, const MetricCorner& a, const MetricCorner& b,
                Slopes& slopes) {
  const Metric m = mean(p.metric, a.metric, b.metric);
  const Uv to_a = a.uv - p.uv, to_b = b.uv - p.uv, opposite = b.uv - a.uv;
  const double squares =
      squared_length(m, to_a) + squared_length(m, to_b) + squared_length(m, opposite);
  const double area = cross(to_a, to_b);
  const Uv of_area{-opposite.v, opposite.u};
  const Uv back = -2.0 * (to_a + to_b);
  const Uv of_squares{m.m11 * back.u + m.m12 * back.v, m.m12 * back.u + m.m22 * back.v};
  const Uv of_ratio = 1 / area * (of_squares - squares / area * of_area);
  const double scale = 1 / (2 * std::numbers::sqrt3 * density(m));
  slopes.first = slopes.first + scale * of_ratio;
  slopes.uu += scale / area * (4 * m.m11 - 2 * of_ratio.u * of_area.u);
  slopes.uv += scale / area * (4 * m.m12 - of_ratio.u * of_area.v - of_ratio.v * of_area.u);
  slopes.vv += scale / area * (4 * m.m22 - 2 * of_ratio.v * of_area.v);
}

}  // namespace

double sum_of_inverse_qualities(const Star& star, const MetricCorner& centre) {
  double sum = 0;
  const MetricCorner* previous = &star.ring().back();
  for (const MetricCorner& next : star.ring()) {
    if (orient2d(centre.uv, previous->uv, next.uv) <= 0) return INFINITY;
    sum += 1 / triangle_quality(centre, *previous, next);
    previous = &next;
  }
  return sum;
}

Uv shape_step(const Star& star, const MetricCorner& centre) {
  Slopes slopes;
  const MetricCorner* previous = &star.ring().back();
  for (const MetricCorner& next : star.ring()) {
    add_slopes(centre, *previous, next, slopes);
    previous = &next;
  }
  const double determinant = slopes.uu * slopes.vv - slopes.uv * slopes.uv;
  return {(slopes.uv * slopes.first.v - slopes.vv * slopes.first.u) / determinant,
          (slopes.uv * slopes.first.u - slopes.uu * slopes.first.v) / determinant};
}

void smooth_shapes(DelaunayMesh& delaunay, const MetricField& field, const RunContext& context) {
  ShapeMoves moves(delaunay, field);
  for (std::size_t i = 0; i < delaunay.n_vertices(); ++i) {
    if (i % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
    moves.smooth(VertexHandle(static_cast<int>(i)), 1, [](Uv) { return true; });
  }
  swap_edges(delaunay, context);
}

}  // namespace surfmesh
