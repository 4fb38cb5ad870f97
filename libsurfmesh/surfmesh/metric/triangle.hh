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
/// Error    below 1 % of edge_length() for ratios of the lengths up to 4 (test FastEdgeLength.*)
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

/// √det M, the metric area of a unit of area in (u,v); 0 for a metric that is singular by rounding.
inline double density(const Metric& m) { return std::sqrt(std::max(0.0, determinant(m))); }

/// Metric area of a unit triangle.
inline constexpr double kUnitTriangleArea = std::numbers::sqrt3 / 4;

/// The unit range: metric lengths whose half and double are no nearer to 1, by ratio.
inline constexpr double kShortestUnit = 1 / std::numbers::sqrt2;
inline constexpr double kLongestUnit = std::numbers::sqrt2;

/// Quality 4√3 A_M / (l1² + l2² + l3²) in a constant metric: 1 for a unit triangle, 0 for a
/// degenerate one, negative for an inverted one.
inline double triangle_quality(Uv a, Uv b, Uv c, const Metric& m) {
  const double sum = squared_length(m, b - a) + squared_length(m, c - b) + squared_length(m, a - c);
  if (!(sum > 0)) return 0 * sum;  // all corners are one point, or unset
  return 2 * std::numbers::sqrt3 * cross(b - a, c - a) * density(m) / sum;
}

/// Quality with the mean metric of the corners, which stands for the one at the barycentre.
inline double triangle_quality(const MetricCorner& a, const MetricCorner& b,
                               const MetricCorner& c) {
  return triangle_quality(a.uv, b.uv, c.uv, mean(a.metric, b.metric, c.metric));
}

/// Squared metric circumradius from the product of the metric lengths of the sides and the metric
/// area: 1/3 for the unit triangle, infinite for a degenerate one.
/// Source   R = abc / 4A
inline double squared_circumradius(double product_of_sides, double metric_area) {
  const double radius = product_of_sides / (4 * metric_area);
  return radius * radius;
}

/// Product of the metric lengths of the sides.
inline double product_of_sides(const MetricCorner& a, const MetricCorner& b,
                               const MetricCorner& c) {
  return fast_edge_length(a.uv, a.metric, b.uv, b.metric) *
         fast_edge_length(b.uv, b.metric, c.uv, c.metric) *
         fast_edge_length(c.uv, c.metric, a.uv, a.metric);
}

/// Metric area with the mean density of the corners; negative if they are clockwise.
inline double metric_area(const MetricCorner& a, const MetricCorner& b, const MetricCorner& c) {
  return cross(b.uv - a.uv, c.uv - a.uv) *
         (density(a.metric) + density(b.metric) + density(c.metric)) / 6;
}

/// Squared metric circumradius of three corners.
inline double squared_circumradius(const MetricCorner& a, const MetricCorner& b,
                                   const MetricCorner& c) {
  return squared_circumradius(product_of_sides(a, b, c), metric_area(a, b, c));
}

}  // namespace surfmesh
