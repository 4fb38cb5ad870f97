// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {

// In-circle rules: function objects (mesh, triangle, point) that are true if the point lies inside
// the circumcircle of the triangle. The kernel takes one as an argument. A rule decides which
// triangles a new point replaces, never whether the result is valid: the kernel checks exact
// orientation itself.

/// The vertices of a triangle, counter-clockwise.
using TriangleVertices = std::array<VertexHandle, 3>;

/// From the tip of its first halfedge on.
inline TriangleVertices vertices(const PolyMesh& mesh, FaceHandle fh) {
  const HalfedgeHandle a = mesh.halfedge_handle(fh);
  const HalfedgeHandle b = mesh.next_halfedge_handle(a);
  const HalfedgeHandle c = mesh.next_halfedge_handle(b);
  return {mesh.to_vertex_handle(a), mesh.to_vertex_handle(b), mesh.to_vertex_handle(c)};
}

/// Parameters of the three vertices of a triangle.
inline std::array<Uv, 3> corners(const PolyMesh& mesh, const TriangleVertices& triangle,
                                 decltype(keys::vertex_uv)::Handle uv) {
  return {mesh.property(uv, triangle[0]), mesh.property(uv, triangle[1]),
          mesh.property(uv, triangle[2])};
}

/// Those of a face.
inline std::array<Uv, 3> corners(const PolyMesh& mesh, FaceHandle fh,
                                 decltype(keys::vertex_uv)::Handle uv) {
  return corners(mesh, vertices(mesh, fh), uv);
}

/// Bound of the relative rounding error of a term of in_metric_circle: about 14 operations of 2⁻⁵³
/// each.
inline constexpr double kInCircleErrorBound = 1.6e-15;

/// True if p lies inside the circumcircle of a counter-clockwise triangle in a constant metric.
///
/// With d_i = corner − p and M = L Lᵀ the sign of in-circle is that of Σ (dᵢᵀ M dᵢ) (d_j × d_k). A
/// sum within its own rounding error counts as outside, so cocircular points do not extend the
/// cavity: which of the equal triangulations results does not matter, so no exact sign is needed.
inline bool in_metric_circle(const std::array<Uv, 3>& triangle, Uv p, const Metric& m) {
  const Uv a = triangle[0] - p, b = triangle[1] - p, c = triangle[2] - p;
  const double la = squared_length(m, a), lb = squared_length(m, b), lc = squared_length(m, c);
  const double bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double sum = la * bc + lb * ca + lc * ab;
  return sum > kInCircleErrorBound * (la * std::abs(bc) + lb * std::abs(ca) + lc * std::abs(ab));
}

/// Circle through the corners of a triangle in a constant metric.
struct MetricCircle {
  Uv centre;
  double squared_radius;  ///< in metric units
};

/// The circumcircle of a triangle; not finite for a degenerate one.
inline MetricCircle circumcircle(const std::array<Uv, 3>& triangle, const Metric& m) {
  const Uv b = triangle[1] - triangle[0], c = triangle[2] - triangle[0];
  const double lb = 0.5 * squared_length(m, b), lc = 0.5 * squared_length(m, c);
  // The centre x, seen from the first corner, has bᵀMx = ½ bᵀMb and cᵀMx = ½ cᵀMc.
  const Uv gb{m.m11 * b.u + m.m12 * b.v, m.m12 * b.u + m.m22 * b.v};
  const Uv gc{m.m11 * c.u + m.m12 * c.v, m.m12 * c.u + m.m22 * c.v};
  const double det = cross(gb, gc);
  const Uv x{(lb * gc.v - lc * gb.v) / det, (lc * gb.u - lb * gc.u) / det};
  return {triangle[0] + x, squared_length(m, x)};
}

/// Constant metric: Euclidean with diag(1,1), or in a parameter plane scaled by its entries. As in
/// the paper, section 2.1, item 2, with the metric at the inserted point.
struct ConstantMetricRule {
  decltype(keys::vertex_uv)::Handle uv;
  Metric metric{1, 0, 1};

  bool operator()(const PolyMesh& mesh, const TriangleVertices& triangle, Uv p) const {
    return in_metric_circle(corners(mesh, triangle, uv), p, metric);
  }
};

/// Mean metric of the triangle's own vertices: more robust than the new point's where the metric
/// turns.
struct TriangleMetricRule {
  decltype(keys::vertex_uv)::Handle uv;
  decltype(keys::vertex_metric)::Handle metric;

  bool operator()(const PolyMesh& mesh, const TriangleVertices& triangle, Uv p) const {
    const Metric m = mean(mesh.property(metric, triangle[0]), mesh.property(metric, triangle[1]),
                          mesh.property(metric, triangle[2]));
    return in_metric_circle(corners(mesh, triangle, uv), p, m);
  }
};

}  // namespace surfmesh
