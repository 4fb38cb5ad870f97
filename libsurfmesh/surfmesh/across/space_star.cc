// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/space_star.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/across/triangle_measures.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

bool SpaceStar::collect(const PolyMesh& mesh, VertexHandle vh) {
  ring_.clear();
  const HalfedgeHandle start = mesh.halfedge_handle(vh);
  if (mesh.is_boundary(start)) return false;
  HalfedgeHandle heh = start;
  do {
    ring_.push_back(mesh.to_vertex_handle(heh));
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
  return true;
}

bool SpaceStar::sees(const VertexChart& centre, const Vec3& point) const {
  Vec3 previous = chart(ring_.back()).point - point;
  for (const VertexHandle vh : ring_) {
    const Vec3 next = chart(vh).point - point;
    if (!(centre.normal.dot(previous.cross(next)) > 0)) return false;
    previous = next;
  }
  return true;
}

double SpaceStar::quality(const VertexChart& centre, double enough) const {
  double least = 1;
  VertexHandle previous = ring_.back();
  for (const VertexHandle next : ring_) {
    least = std::min(least, triangle_quality(centre, chart(previous), chart(next)));
    if (least <= enough) return least;
    previous = next;
  }
  return least;
}

double SpaceStar::score(const VertexChart& centre, double enough) const {
  const double least = quality(centre, enough);
  if (least <= std::max(enough, 0.0)) return least;
  double excess = 0;
  for (const VertexHandle vh : ring_) {
    const double length = metric_length(centre, chart(vh));
    excess = std::max({excess, kShortestUnit - length, length - kLongestUnit});
  }
  // A valid place never scores below an inverted one.
  return std::max(least - 0.5 * excess, 0.0);
}

ChartStep SpaceStar::spring_step(const VertexChart& centre) const {
  double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
  for (const VertexHandle vh : ring_) {
    const VertexChart& other = chart(vh);
    const Vec3 edge = centre.point - other.point;
    const Vec3 own = centre.tensor * edge, theirs = other.tensor * edge;
    const double length = fast_edge_length(edge.dot(own), edge.dot(theirs));
    const Vec3 gradient = 0.5 / length * (own + theirs);
    const double g1 = gradient.dot(centre.x), g2 = gradient.dot(centre.y);
    a11 += g1 * g1;
    a12 += g1 * g2;
    a22 += g2 * g2;
    b1 += g1 * (1 - length);
    b2 += g2 * (1 - length);
  }
  const double determinant = a11 * a22 - a12 * a12;
  return {(a22 * b1 - a12 * b2) / determinant, (a11 * b2 - a12 * b1) / determinant};
}

}  // namespace surfmesh
