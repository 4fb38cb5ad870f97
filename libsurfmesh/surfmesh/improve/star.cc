// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/star.hh"

#include <algorithm>

#include "surfmesh/delaunay/predicates.hh"

namespace surfmesh {

bool Star::collect(const DelaunayMesh& delaunay, VertexHandle vh) {
  const PolyMesh& mesh = delaunay.mesh();
  ring_.clear();
  const HalfedgeHandle start = mesh.halfedge_handle(vh);
  if (mesh.is_boundary(start)) return false;
  HalfedgeHandle heh = start;
  do {
    ring_.push_back(corner(delaunay, mesh.to_vertex_handle(heh)));
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
  return true;
}

bool Star::sees(Uv p) const {
  const MetricCorner* previous = &ring_.back();
  for (const MetricCorner& next : ring_) {
    if (orient2d(p, previous->uv, next.uv) <= 0) return false;
    previous = &next;
  }
  return true;
}

double Star::quality(const MetricCorner& p) const {
  double least = 1;
  const MetricCorner* previous = &ring_.back();
  for (const MetricCorner& next : ring_) {
    if (orient2d(p.uv, previous->uv, next.uv) <= 0) return -1;
    least = std::min(least, triangle_quality(p, *previous, next));
    previous = &next;
  }
  return least;
}

}  // namespace surfmesh
