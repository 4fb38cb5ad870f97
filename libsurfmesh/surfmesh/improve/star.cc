// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/star.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/geometry/predicates.hh"

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

void Star::begin_at_worst(const MetricCorner& p) {
  const MetricCorner* previous = &ring_.back();
  std::size_t worst = 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const double quality = triangle_quality(p, *previous, ring_[i]);
    if (quality < least) {
      least = quality;
      worst = i;
    }
    previous = &ring_[i];
  }
  std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(worst), ring_.end());
}

double Star::quality(const MetricCorner& p, double enough) const {
  double least = 1;
  const MetricCorner* previous = &ring_.back();
  for (const MetricCorner& next : ring_) {
    if (orient2d(p.uv, previous->uv, next.uv) <= 0) return -1;
    least = std::min(least, triangle_quality(p, *previous, next));
    if (least <= enough) return least;
    previous = &next;
  }
  return least;
}

}  // namespace surfmesh
