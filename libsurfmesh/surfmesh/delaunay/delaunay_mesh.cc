// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/delaunay_mesh.hh"

#include <fmt/format.h>

#include <deque>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/renumber.hh"
#include "surfmesh/delaunay/spatial_order.hh"

namespace surfmesh {

DelaunayMesh::DelaunayMesh(Uv lower, Uv upper)
    : DelaunayMesh({lower, {upper.u, lower.v}, upper, {lower.u, upper.v}}, {{0, 1, 2}, {0, 2, 3}}) {
}

DelaunayMesh::DelaunayMesh(const std::vector<Uv>& points,
                           const std::vector<std::array<int, 3>>& triangles)
    : owned_(std::make_unique<PolyMesh>()),
      mesh_(*owned_),
      uv_(attach(mesh_, keys::vertex_uv)),
      metric_(attach(mesh_, keys::vertex_metric)),
      constrained_(attach(mesh_, keys::edge_constrained)),
      pool_((build_triangles(mesh_, points.size(), triangles), mesh_)) {
  for (std::size_t i = 0; i < points.size(); ++i) uv(VertexHandle(static_cast<int>(i))) = points[i];
  for (std::size_t i = 0; i < mesh_.n_edges(); ++i) {
    const EdgeHandle eh(static_cast<int>(i));
    if (mesh_.is_boundary(mesh_.halfedge_handle(eh, 0)) ||
        mesh_.is_boundary(mesh_.halfedge_handle(eh, 1))) {
      constrain(eh);
    }
  }
}

DelaunayMesh::DelaunayMesh(std::unique_ptr<PolyMesh> mesh)
    : owned_(std::move(mesh)),
      mesh_(*owned_),
      uv_(require(mesh_, keys::vertex_uv)),
      metric_(require(mesh_, keys::vertex_metric)),
      constrained_(require(mesh_, keys::edge_constrained)),
      pool_(mesh_) {}

std::unique_ptr<PolyMesh> DelaunayMesh::release() {
  shrink();
  return std::move(owned_);
}

void DelaunayMesh::sort_spatially(std::size_t fixed) {
  std::vector<int> order(fixed);
  std::iota(order.begin(), order.end(), 0);
  const std::vector<Uv>& uvs = mesh_.property(uv_).data_vector();
  for (const int i : cell_order(std::span(uvs).subspan(fixed))) {
    order.push_back(i + static_cast<int>(fixed));
  }
  const Numbering numbering = number_along(mesh_, order);
  renumber(mesh_, numbering);
  renumber_values(mesh_.property(uv_).data_vector(), numbering.vertex);
  renumber_values(mesh_.property(metric_).data_vector(), numbering.vertex);
  renumber_values(mesh_.property(constrained_).data_vector(), numbering.edge);
}

bool DelaunayMesh::is_insertable(const Location& location) const {
  if (location.kind == Location::Kind::Inside) return true;
  if (location.kind != Location::Kind::OnEdge) return false;
  return !is_constrained(mesh_.edge_handle(location.edge)) ||
         mesh_.is_boundary(mesh_.opposite_halfedge_handle(location.edge));
}

/// The cavity of the located triangle alone, or of the two at the located edge.
void DelaunayMesh::seed_cavity(const Location& location, Cavity& cavity) {
  cavity.clear();
  cavity.faces.push_back(location.face);
  if (location.kind == Location::Kind::Inside) {
    const HalfedgeHandle heh = mesh_.halfedge_handle(location.face);
    const HalfedgeHandle next = mesh_.next_halfedge_handle(heh);
    cavity.rim = {heh, next, mesh_.next_halfedge_handle(next)};
    return;
  }
  const HalfedgeHandle next = mesh_.next_halfedge_handle(location.edge);
  cavity.rim = {next, mesh_.next_halfedge_handle(next)};
  const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(location.edge);
  if (mesh_.is_boundary(opposite)) {
    cavity.split = location.edge;
    return;
  }
  cavity.faces.push_back(mesh_.face_handle(opposite));
  cavity.inner_edges.push_back(mesh_.edge_handle(opposite));
  const HalfedgeHandle opposite_next = mesh_.next_halfedge_handle(opposite);
  cavity.rim.push_back(opposite_next);
  cavity.rim.push_back(mesh_.next_halfedge_handle(opposite_next));
}

bool DelaunayMesh::can_flip(EdgeHandle eh) const {
  const HalfedgeHandle a = mesh_.halfedge_handle(eh, 0);
  const HalfedgeHandle b = mesh_.halfedge_handle(eh, 1);
  if (is_constrained(eh) || mesh_.is_boundary(a) || mesh_.is_boundary(b)) return false;
  const Uv origin = uv(mesh_.to_vertex_handle(b));
  const Uv tip = uv(mesh_.to_vertex_handle(a));
  const Uv left = uv(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(a)));
  const Uv right = uv(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(b)));
  return orient2d(right, tip, left) > 0 && orient2d(left, origin, right) > 0;
}

void DelaunayMesh::collapse(HalfedgeHandle heh) {
  pool_.remove(surfmesh::collapse(mesh_, heh), [this]<class Handle>(Handle from, Handle to) {
    if constexpr (std::is_same_v<Handle, VertexHandle>) {
      uv(to) = uv(from);
      metric(to) = metric(from);
    } else if constexpr (std::is_same_v<Handle, EdgeHandle>) {
      mesh_.property(constrained_, to) = mesh_.property(constrained_, from);
    }
  });
}

HalfedgeHandle DelaunayMesh::find_halfedge(VertexHandle a, VertexHandle b) const {
  const HalfedgeHandle start = mesh_.halfedge_handle(a);
  HalfedgeHandle heh = start;
  do {
    if (mesh_.to_vertex_handle(heh) == b) return heh;
    heh = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(heh));
  } while (heh != start);
  return HalfedgeHandle();
}

/// The side, of a triangle at a, through which the segment to b leaves; or the halfedge from a to
/// a vertex on the segment.
HalfedgeHandle DelaunayMesh::first_crossing(VertexHandle a, VertexHandle b) const {
  const Uv from = uv(a), to = uv(b);
  const HalfedgeHandle start = mesh_.halfedge_handle(a);
  HalfedgeHandle heh = start;
  do {
    const HalfedgeHandle far = mesh_.next_halfedge_handle(heh);
    const Uv right = uv(mesh_.to_vertex_handle(heh));
    const Uv forward = to - from, step = right - from;
    const int side = orient2d(from, right, to);
    if (side == 0 && forward.u * step.u + forward.v * step.v > 0) return heh;
    if (!mesh_.is_boundary(heh) && side > 0 &&
        orient2d(from, uv(mesh_.to_vertex_handle(far)), to) < 0) {
      return far;
    }
    heh = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(heh));
  } while (heh != start);
  throw Error(ErrorCode::Geometry,
              fmt::format("the boundary leaves the domain at (u,v) = ({}, {})", from.u, from.v));
}

/// List the edges that the segment from a crosses up to the first vertex on it, and return that.
VertexHandle DelaunayMesh::collect_crossings(VertexHandle a, VertexHandle b,
                                             std::vector<EdgeHandle>& crossed) {
  crossed.clear();
  HalfedgeHandle heh = first_crossing(a, b);
  if (mesh_.from_vertex_handle(heh) == a) return mesh_.to_vertex_handle(heh);
  while (true) {
    const EdgeHandle eh = mesh_.edge_handle(heh);
    if (is_constrained(eh)) {
      const Uv at = uv(mesh_.to_vertex_handle(heh));
      throw Error(ErrorCode::Geometry,
                  fmt::format("the boundary crosses itself near (u,v) = ({}, {})", at.u, at.v));
    }
    crossed.push_back(eh);
    const HalfedgeHandle next = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(heh));
    const VertexHandle apex = mesh_.to_vertex_handle(next);
    const int side = orient2d(uv(a), uv(b), uv(apex));
    if (apex == b || side == 0) return apex;
    heh = side > 0 ? next : mesh_.next_halfedge_handle(next);
  }
}

bool DelaunayMesh::crosses(EdgeHandle eh, VertexHandle a, VertexHandle b) const {
  const VertexHandle x = mesh_.to_vertex_handle(mesh_.halfedge_handle(eh, 0));
  const VertexHandle y = mesh_.to_vertex_handle(mesh_.halfedge_handle(eh, 1));
  if (x == a || x == b || y == a || y == b) return false;
  return orient2d(uv(a), uv(b), uv(x)) * orient2d(uv(a), uv(b), uv(y)) < 0;
}

void DelaunayMesh::remove_crossings(VertexHandle a, VertexHandle b,
                                    std::vector<EdgeHandle>& crossed) {
  std::deque<EdgeHandle> queue(crossed.begin(), crossed.end());
  // Each swap takes away a crossing or waits for a neighbour's; n² bounds both.
  std::size_t limit = 4 * (queue.size() + 4) * (queue.size() + 4);
  while (!queue.empty()) {
    if (limit-- == 0) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("a boundary edge could not be recovered near (u,v) = ({}, {})",
                              uv(a).u, uv(a).v));
    }
    const EdgeHandle eh = queue.front();
    queue.pop_front();
    if (can_flip(eh)) flip(eh);
    if (crosses(eh, a, b)) queue.push_back(eh);
  }
}

void DelaunayMesh::insert_constraint(VertexHandle a, VertexHandle b) {
  std::vector<EdgeHandle> crossed;
  while (a != b) {
    const VertexHandle next = collect_crossings(a, b, crossed);
    if (!crossed.empty()) remove_crossings(a, next, crossed);
    constrain(mesh_.edge_handle(find_halfedge(a, next)));
    a = next;
  }
}

}  // namespace surfmesh
