// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/delaunay/metric_swaps.hh"

namespace surfmesh {

/// A base edge from a to b, and the third corner of the triangle on its left.
struct BaseTriangle {
  MetricCorner a, b, apex;
};

/// The triangle on the left of a halfedge, with that halfedge as its base.
inline BaseTriangle triangle_at(const DelaunayMesh& delaunay, HalfedgeHandle base) {
  const PolyMesh& mesh = delaunay.mesh();
  return {corner(delaunay, mesh.from_vertex_handle(base)),
          corner(delaunay, mesh.to_vertex_handle(base)),
          corner(delaunay, mesh.to_vertex_handle(mesh.next_halfedge_handle(base)))};
}

/// The metric circumcentre of a triangle, in the mean metric of its corners; not finite for a
/// degenerate triangle.
Uv circumcentre(const BaseTriangle& triangle);

/// The point that forms a unit triangle with the base, in the mean metric of its ends. Nothing if
/// the circumcentre is nearer, or if the base is too long.
///
/// It is at height d = √(1 − l²/4) above the base, if the circumcentre is higher.
std::optional<Uv> frontal_point(const BaseTriangle& triangle);

/// Move a frontal point so that both of its edges to the base have unit length, to first order.
///
/// One Newton step of at most half a unit, with the metric of the point itself; a second step gains
/// nothing.
Uv correct_frontal_point(const BaseTriangle& triangle, const MetricCorner& point);

}  // namespace surfmesh
