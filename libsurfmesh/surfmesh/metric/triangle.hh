// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {

/// Metric length of an edge from its squared lengths in the metrics of its two ends, without a
/// logarithm: Simpson's rule with the geometric mean in the middle.
///
/// Error    below 1 % of edge_length() for ratios of the two lengths up to 4 (test FastEdgeLength.*)
inline double fast_edge_length(double squared0, double squared1) {
  const double l0 = std::sqrt(squared0), l1 = std::sqrt(squared1);
  return (2 * std::sqrt(l0 * l1) + 0.5 * (l0 + l1)) / 3;
}

/// Metric length of the edge from a to b with a metric at each end.
inline double fast_edge_length(Uv a, const Metric& metric_a, Uv b, const Metric& metric_b) {
  const Uv step = b - a;
  return fast_edge_length(squared_length(metric_a, step), squared_length(metric_b, step));
}

/// A corner of a triangle in the parameters of a patch.
struct MetricCorner {
  Uv uv;
  Metric metric;
};

/// Quality 4√3 A_M / (l1² + l2² + l3²) in a constant metric: 1 for a unit triangle, 0 for a
/// degenerate one, negative for an inverted one.
inline double triangle_quality(Uv a, Uv b, Uv c, const Metric& m) {
  const double sum = squared_length(m, b - a) + squared_length(m, c - b) + squared_length(m, a - c);
  if (!(sum > 0)) return 0 * sum;  // all corners are one point, or unset
  // A metric that is singular by rounding has no area.
  const double density = std::sqrt(std::max(0.0, determinant(m)));
  return 2 * std::numbers::sqrt3 * cross(b - a, c - a) * density / sum;
}

/// Quality with the mean metric of the corners, which stands for the one at the barycentre.
inline double triangle_quality(const MetricCorner& a, const MetricCorner& b,
                               const MetricCorner& c) {
  return triangle_quality(a.uv, b.uv, c.uv, mean(a.metric, b.metric, c.metric));
}

/// Squared metric circumradius from the metric lengths of the sides and the mean of √det M: 1/3
/// for the unit triangle, infinite for a degenerate one.
/// Source   R = abc / 4A
inline double squared_circumradius(const MetricCorner& a, const MetricCorner& b,
                                   const MetricCorner& c) {
  const double sides = fast_edge_length(a.uv, a.metric, b.uv, b.metric) *
                       fast_edge_length(b.uv, b.metric, c.uv, c.metric) *
                       fast_edge_length(c.uv, c.metric, a.uv, a.metric);
  const double density = (std::sqrt(determinant(a.metric)) + std::sqrt(determinant(b.metric)) +
                          std::sqrt(determinant(c.metric))) /
                         3;
  const double radius = sides / (2 * cross(b.uv - a.uv, c.uv - a.uv) * density);
  return radius * radius;
}

}  // namespace surfmesh
