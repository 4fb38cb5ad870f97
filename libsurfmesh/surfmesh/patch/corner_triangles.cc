// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/corner_triangles.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh::detail {

namespace {

/// The sum of the metrics, as good as their mean for a quality.
Metric sum_of_metrics(const CornerTriangle& t) {
  Metric sum{0, 0, 0};
  for (const PatchCorner& corner : t) {
    sum.m11 += corner.metric.m11;
    sum.m12 += corner.metric.m12;
    sum.m22 += corner.metric.m22;
  }
  return sum;
}

}  // namespace

double shape_of(const CornerTriangle& t) {
  const auto& [a, b, c] = t;
  const Vec3 normal = (b.point - a.point).cross(c.point - a.point);
  const double squares = (b.point - a.point).squaredNorm() + (c.point - b.point).squaredNorm() +
                         (a.point - c.point).squaredNorm();
  const double shape = squares > 0 ? 2 * std::numbers::sqrt3 * normal.norm() / squares : 0;
  if (!(normal.dot(a.normal + b.normal + c.normal) > 0)) return -shape;
  return std::max(shape, triangle_quality(a.uv, b.uv, c.uv, sum_of_metrics(t)));
}

double shape_of(const CornerTriangles& triangles) {
  double shape = 1;
  for (const CornerTriangle& t : triangles) shape = std::min(shape, shape_of(t));
  return shape;
}

PatchCorner corner_of(const TriangulatedPatch& patch, VertexHandle vh) {
  const std::size_t v = index(vh);
  PatchCorner corner{patch.delaunay->uv(vh), patch.points[v], patch.normals[v]};
  if (patch.has_shapes_of_metric) corner.metric = patch.delaunay->metric(vh);
  return corner;
}

PatchCorner corner_at(const TriangulatedPatch& patch, Uv uv) {
  const Jet jet = patch.surface->evaluate(uv, Order::First);
  return {uv, jet.point, jet.du.cross(jet.dv)};
}

bool is_inner(const TriangulatedPatch& patch, EdgeHandle eh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  return !patch.delaunay->is_constrained(eh) && !mesh.is_boundary(mesh.halfedge_handle(eh, 0)) &&
         !mesh.is_boundary(mesh.halfedge_handle(eh, 1));
}

std::vector<EdgeHandle> inner_edges(const TriangulatedPatch& patch, FaceHandle fh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  std::vector<EdgeHandle> edges;
  HalfedgeHandle heh = mesh.halfedge_handle(fh);
  for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
    if (is_inner(patch, mesh.edge_handle(heh))) edges.push_back(mesh.edge_handle(heh));
  }
  return edges;
}

Diamond diamond_of(const TriangulatedPatch& patch, EdgeHandle eh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  const HalfedgeHandle a = mesh.halfedge_handle(eh, 0), b = mesh.halfedge_handle(eh, 1);
  return {corner_of(patch, mesh.to_vertex_handle(b)),
          corner_of(patch, mesh.to_vertex_handle(mesh.next_halfedge_handle(b))),
          corner_of(patch, mesh.to_vertex_handle(a)),
          corner_of(patch, mesh.to_vertex_handle(mesh.next_halfedge_handle(a)))};
}

double squared_length(const TriangulatedPatch& patch, EdgeHandle eh) {
  const HalfedgeHandle heh = patch.delaunay->mesh().halfedge_handle(eh, 0);
  const Vec3& tip = patch.points[index(patch.delaunay->mesh().to_vertex_handle(heh))];
  const Vec3& origin = patch.points[index(patch.delaunay->mesh().from_vertex_handle(heh))];
  return (tip - origin).squaredNorm();
}

std::vector<VertexHandle> ring_of(const TriangulatedPatch& patch, VertexHandle vh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  std::vector<VertexHandle> ring;
  for (const HalfedgeHandle heh : mesh.voh_range(vh)) ring.push_back(mesh.to_vertex_handle(heh));
  return ring;
}

CornerTriangles star_of(const TriangulatedPatch& patch, VertexHandle vh,
                        const PatchCorner& centre) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  CornerTriangles triangles;
  for (const HalfedgeHandle heh : mesh.voh_range(vh)) {
    const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
    triangles.push_back({centre, corner_of(patch, mesh.to_vertex_handle(heh)),
                         corner_of(patch, mesh.to_vertex_handle(next))});
  }
  return triangles;
}

}  // namespace surfmesh::detail
