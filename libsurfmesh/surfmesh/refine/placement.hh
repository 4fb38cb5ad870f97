// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/delaunay/metric_swaps.hh"

namespace surfmesh {

/// A base edge from a to b and the corner of its triangle on the left.
struct BaseTriangle {
  MetricCorner a, b, apex;
};

/// The triangle on the left of a halfedge, with this as its base.
inline BaseTriangle triangle_at(const DelaunayMesh& delaunay, HalfedgeHandle base) {
  const PolyMesh& mesh = delaunay.mesh();
  return {corner(delaunay, mesh.from_vertex_handle(base)),
          corner(delaunay, mesh.to_vertex_handle(base)),
          corner(delaunay, mesh.to_vertex_handle(mesh.next_halfedge_handle(base)))};
}

/// The metric circumcentre of a triangle, in the mean metric of its corners; not finite for a
/// degenerate triangle.
Uv circumcentre(const BaseTriangle& triangle);

/// The point that makes a unit triangle with the base in the mean metric of its ends; nothing where
/// the circumcentre is nearer, or the base too long for one.
///
/// At the height d = √(1 − l²/4) over the base, if the circumcentre is higher.
std::optional<Uv> frontal_point(const BaseTriangle& triangle);

/// Move a frontal point to where both its edges to the base are units, to first order.
///
/// One Newton step, at most half a unit, with the metric of the point itself; a second one gains
/// nothing.
Uv correct_frontal_point(const BaseTriangle& triangle, const MetricCorner& point);

}  // namespace surfmesh
