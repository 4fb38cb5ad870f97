// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/delaunay/metric_swaps.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

/// The side of a triangle that lies across from a vertex, and the metric length from that vertex to
/// the origin of the side.
struct FanSide {
  HalfedgeHandle halfedge;
  double spoke;
};

/// The triangles around an inner vertex, counter-clockwise.
using Fan = std::vector<FanSide>;

/// Collect the fan of a vertex; memory is kept.
inline void collect_fan(const DelaunayMesh& delaunay, VertexHandle vh, Fan& fan) {
  const PolyMesh& mesh = delaunay.mesh();
  const MetricCorner centre = corner(delaunay, vh);
  const HalfedgeHandle start = mesh.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  fan.clear();
  do {
    const MetricCorner a = corner(delaunay, mesh.to_vertex_handle(heh));
    fan.push_back({mesh.next_halfedge_handle(heh),
                   fast_edge_length(a.uv, a.metric, centre.uv, centre.metric)});
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
}

}  // namespace surfmesh
