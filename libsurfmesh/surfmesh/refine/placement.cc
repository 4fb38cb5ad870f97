// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/placement.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/delaunay/in_circle.hh"
#include "surfmesh/metric/perpendicular.hh"

namespace surfmesh {
namespace {

/// Longest Newton step, in metric units.
constexpr double kLongestStep = 0.5;

/// The orthonormal frame of a base edge in a constant metric.
struct BaseFrame {
  Uv middle;
  Uv along;   ///< unit length, from a to b
  Uv across;  ///< unit length, to the left
  double half;
  double height_of_circumcentre;
};

BaseFrame make_frame(const BaseTriangle& t, const Metric& m) {
  const Uv edge = t.b.uv - t.a.uv;
  const double length = std::sqrt(squared_length(m, edge));
  BaseFrame frame;
  frame.middle = 0.5 * (t.a.uv + t.b.uv);
  frame.along = (1 / length) * edge;
  frame.across = unit_left_of(edge, length, m);
  frame.half = 0.5 * length;
  const Uv apex = t.apex.uv - frame.middle;
  const double x = inner_product(m, frame.along, apex), y = inner_product(m, frame.across, apex);
  frame.height_of_circumcentre = (x * x + y * y - frame.half * frame.half) / (2 * y);
  return frame;
}

/// The step that makes the lengths from a and b to p both `wanted`, to first order.
Uv newton_step(const BaseTriangle& t, const MetricCorner& p, double wanted) {
  const Metric ma = mean(t.a.metric, p.metric), mb = mean(t.b.metric, p.metric);
  const Uv ea = p.uv - t.a.uv, eb = p.uv - t.b.uv;
  const double la = fast_edge_length(t.a.uv, t.a.metric, p.uv, p.metric);
  const double lb = fast_edge_length(t.b.uv, t.b.metric, p.uv, p.metric);
  const Uv ga{(ma.m11 * ea.u + ma.m12 * ea.v) / la, (ma.m12 * ea.u + ma.m22 * ea.v) / la};
  const Uv gb{(mb.m11 * eb.u + mb.m12 * eb.v) / lb, (mb.m12 * eb.u + mb.m22 * eb.v) / lb};
  const double determinant = cross(ga, gb);
  const double ra = wanted - la, rb = wanted - lb;
  const Uv step{(ra * gb.v - rb * ga.v) / determinant, (ga.u * rb - gb.u * ra) / determinant};
  const double length = std::sqrt(squared_length(p.metric, step));
  if (!(length < INFINITY)) return {0, 0};
  return length > kLongestStep ? (kLongestStep / length) * step : step;
}

}  // namespace

Uv circumcentre(const BaseTriangle& t) {
  return circumcircle({t.a.uv, t.b.uv, t.apex.uv}, mean(t.a.metric, t.b.metric, t.apex.metric))
      .centre;
}

std::optional<Uv> frontal_point(const BaseTriangle& t) {
  const BaseFrame frame = make_frame(t, mean(t.a.metric, t.b.metric));
  const double squared_height = 1 - frame.half * frame.half;
  const double limit = frame.height_of_circumcentre;
  if (!(limit > 0) || squared_height <= 0 || squared_height >= limit * limit) return std::nullopt;
  return frame.middle + std::sqrt(squared_height) * frame.across;
}

Uv correct_frontal_point(const BaseTriangle& t, const MetricCorner& point) {
  return point.uv + newton_step(t, point, 1.0);
}

}  // namespace surfmesh
