// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "surfmesh/quad/front_quads.hh"

namespace surfmesh {
namespace {

/// How much a side of another length than 1 takes from the score of a quad, times |ln length|.
constexpr double kLengthWeight = 0.3;

}  // namespace

FaceHandle FrontQuads::make(HalfedgeHandle base, const QuadCycle& cycle, double least_jacobian) {
  if (!(mesh_.least_jacobian(cycle) >= least_jacobian)) return FaceHandle();
  const FaceHandle quad = mesh_.make_quad(base, cycle);
  if (!quad.is_valid()) return quad;
  if (!parity_.is_even_around(quad) || mesh_.leaves_straight_gap(quad)) {
    mesh_.undo();
    return FaceHandle();
  }
  mesh_.keep();
  return quad;
}

FaceHandle FrontQuads::drop_corner(HalfedgeHandle heh) {
  const FaceHandle quad = mesh_.drop_corner(heh);
  if (!quad.is_valid() || parity_.is_even_around(quad)) return quad;
  mesh_.undo();
  return FaceHandle();
}

/// The third vertex of the triangle behind a halfedge; invalid if there is no triangle.
VertexHandle FrontQuads::apex_beyond(HalfedgeHandle heh) const {
  const HalfedgeHandle beyond = mesh_.mesh().opposite_halfedge_handle(heh);
  if (!mesh_.is_triangle(mesh_.mesh().face_handle(beyond))) return VertexHandle();
  return mesh_.mesh().to_vertex_handle(mesh_.mesh().next_halfedge_handle(beyond));
}

/// The quad whose side at one end leads to `side`, and whose other corner is `top`.
QuadCycle FrontQuads::cycle_at(const FrontEdge& edge, End end, VertexHandle side,
                               VertexHandle top) const {
  const VertexHandle a = edge.from.vertex, b = edge.to.vertex;
  return end == End::To ? QuadCycle{a, b, side, top} : QuadCycle{a, b, top, side};
}

/// Score a quad by its worst corner and its lengths, in the metric at the middle of its base.
void FrontQuads::add_merger(const FrontEdge& edge, EdgeHandle swapped, const QuadCycle& cycle) {
  std::array<Uv, 4> sides;
  std::array<double, 4> lengths;
  double uneven = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    sides[k] = edge.frame.in_frame(mesh_.uv(cycle[(k + 1) % 4]) - mesh_.uv(cycle[k]));
    lengths[k] = std::sqrt(sides[k].u * sides[k].u + sides[k].v * sides[k].v);
    if (k > 0) uneven += std::abs(std::log(lengths[k]));
  }
  double least = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    least = std::min(least, cross(sides[k], sides[next]) / (lengths[k] * lengths[next]));
  }
  mergers_.push_back({least - kLengthWeight * uneven / 3, swapped, cycle});
}

/// Collect the quads that take up the triangle at one end of the front edge.
void FrontQuads::collect_mergers(const FrontEdge& edge, End end) {
  const PolyMesh& mesh = mesh_.mesh();
  const HalfedgeHandle side =
      end == End::To ? mesh.next_halfedge_handle(edge.base) : mesh.prev_halfedge_handle(edge.base);
  const VertexHandle apex = mesh.to_vertex_handle(mesh.next_halfedge_handle(edge.base));
  const VertexHandle tip = apex_beyond(side);
  if (!tip.is_valid()) return;
  add_merger(edge, EdgeHandle(), cycle_at(edge, end, tip, apex));
  const HalfedgeHandle beyond = mesh.opposite_halfedge_handle(side);
  HalfedgeHandle at_end = mesh.next_halfedge_handle(beyond);
  HalfedgeHandle at_apex = mesh.prev_halfedge_handle(beyond);
  if (end == End::From) std::swap(at_end, at_apex);
  for (const HalfedgeHandle heh : {at_end, at_apex}) {
    const EdgeHandle eh = mesh.edge_handle(heh);
    if (mesh_.can_flip(eh)) add_merger(edge, eh, cycle_at(edge, end, apex_beyond(heh), apex));
  }
  const VertexHandle far = apex_beyond(at_end);
  if (far.is_valid() && mesh_.can_flip(mesh.edge_handle(side))) {
    add_merger(edge, mesh.edge_handle(side), cycle_at(edge, end, far, tip));
  }
}

FaceHandle FrontQuads::merge(const FrontEdge& edge, double least_jacobian) {
  mergers_.clear();
  collect_mergers(edge, End::From);
  collect_mergers(edge, End::To);
  std::stable_sort(mergers_.begin(), mergers_.end(),
                   [](const Merger& a, const Merger& b) { return a.score > b.score; });
  for (const Merger& merger : mergers_) {
    if (merger.swapped.is_valid()) mesh_.flip(merger.swapped);
    const FaceHandle quad = make(edge.base, merger.cycle, least_jacobian);
    if (quad.is_valid()) return quad;
    if (merger.swapped.is_valid()) mesh_.flip(merger.swapped);
  }
  return FaceHandle();
}

}  // namespace surfmesh
