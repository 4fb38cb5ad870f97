// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/triangle_measures.hh"

#include <algorithm>
#include <numbers>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

namespace {

/// The same whichever comes first: otherwise swaps could go round in circles.
bool are_beside(const VertexChart& a, const VertexChart& b) {
  return a.is_beside(b) && b.is_beside(a);
}

}  // namespace

double metric_length(const VertexChart& a, const VertexChart& b) {
  const Vec3 step = b.point - a.point;
  return fast_edge_length(a.tensor.squared_length(step), b.tensor.squared_length(step));
}

double triangle_quality(const VertexChart& a, const VertexChart& b, const VertexChart& c) {
  if (!do_normals_agree(a, b, c)) return -1;
  const Vec3 ab = b.point - a.point, ac = c.point - a.point;
  const Vec3 normal = ab.cross(ac);
  if (!(a.normal.dot(normal) > 0 && b.normal.dot(normal) > 0 && c.normal.dot(normal) > 0)) {
    return -1;
  }
  const SpaceTensor sum = a.tensor + b.tensor + c.tensor;
  const double squares =
      sum.squared_length(ab) + sum.squared_length(ac) + sum.squared_length(c.point - b.point);
  const double area = (a.density + b.density + c.density) * normal.norm();
  const double in_space = 2 * std::numbers::sqrt3 * area / squares;
  if (!are_beside(a, b) || !are_beside(b, c) || !are_beside(c, a)) return in_space;
  const double in_parameters =
      triangle_quality(a.place.uv, b.place.uv, c.place.uv, mean(a.metric, b.metric, c.metric));
  return std::min(in_space, a.area_of_parameters > 0 ? in_parameters : -in_parameters);
}

}  // namespace surfmesh
