// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/front_edge.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

/// An end whose front edges are the first and the last side of an angle, counter-clockwise.
FrontEnd measure_end(const FrontMesh& mesh, const RootFrame& frame, VertexHandle vertex,
                     std::array<VertexHandle, 2> sides) {
  const Uv x = frame.in_frame(mesh.uv(sides[0]) - mesh.uv(vertex));
  const Uv y = frame.in_frame(mesh.uv(sides[1]) - mesh.uv(vertex));
  FrontEnd end;
  end.vertex = vertex;
  end.angle = std::atan2(cross(x, y), x.u * y.u + x.v * y.v);
  if (!(end.angle > 0)) end.angle += 2 * std::numbers::pi;
  end.quads = std::max(1, static_cast<int>(std::lround(end.angle / (0.5 * std::numbers::pi))));
  return end;
}

}  // namespace

FrontEdge measure_front(FrontMesh& mesh, HalfedgeHandle base) {
  const PolyMesh& connectivity = mesh.mesh();
  const VertexHandle a = connectivity.from_vertex_handle(base);
  const VertexHandle b = connectivity.to_vertex_handle(base);
  const VertexHandle before = connectivity.from_vertex_handle(mesh.previous_front(base));
  const VertexHandle after = connectivity.to_vertex_handle(mesh.next_front(base));
  const Uv step = mesh.uv(b) - mesh.uv(a);
  const Metric middle = mesh.metric_at(lerp(mesh.uv(a), mesh.uv(b), 0.5));
  FrontEdge edge;
  edge.base = base;
  edge.frame = RootFrame(middle);
  edge.length = std::sqrt(squared_length(middle, step));
  edge.from = measure_end(mesh, edge.frame, a, {b, before});
  edge.from.beyond = before;
  edge.to = measure_end(mesh, edge.frame, b, {after, a});
  edge.to.beyond = after;
  return edge;
}

}  // namespace surfmesh
