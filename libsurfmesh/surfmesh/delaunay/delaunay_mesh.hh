// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "surfmesh/core/topology.hh"
#include "surfmesh/delaunay/in_circle.hh"
#include "surfmesh/delaunay/locate.hh"
#include "surfmesh/geometry/predicates.hh"

namespace surfmesh {

/// The one triangulation kernel, for control meshes and domain meshes.
///
/// A PolyMesh with surf:uv, surf:metric and surf:constrained, to which points are added by the
/// empty cavity or by edge swaps, with an in-circle rule as argument. Whatever the rule says, every
/// triangle keeps a strictly positive area (exact orientation), and constrained edges stay.
///
/// The mesh has surplus elements at the end of its arrays until shrink(); count and iterate with
/// n_vertices(), n_edges(), n_faces().
class DelaunayMesh {
 public:
  using UvHandle = decltype(keys::vertex_uv)::Handle;
  using MetricHandle = decltype(keys::vertex_metric)::Handle;
  using ConstrainedHandle = decltype(keys::edge_constrained)::Handle;

  /// Start from two triangles that cover a rectangle.
  DelaunayMesh(Uv lower, Uv upper);

  /// Start from counter-clockwise triangles; their open edges become constrained.
  DelaunayMesh(const std::vector<Uv>& points, const std::vector<std::array<int, 3>>& triangles);

  /// Go on with a mesh of triangles that release() has handed out.
  /// Reads    surf:uv, surf:metric (vertex), surf:constrained (edge)
  /// Throws   MissingProperty
  explicit DelaunayMesh(std::unique_ptr<PolyMesh> mesh);

  DelaunayMesh(const DelaunayMesh&) = delete;
  DelaunayMesh& operator=(const DelaunayMesh&) = delete;

  // --- the mesh ---

  PolyMesh& mesh() { return mesh_; }
  const PolyMesh& mesh() const { return mesh_; }
  UvHandle uv_handle() const { return uv_; }
  MetricHandle metric_handle() const { return metric_; }

  std::size_t n_vertices() const { return pool_.n_vertices(); }
  std::size_t n_edges() const { return pool_.n_edges(); }
  std::size_t n_faces() const { return pool_.n_faces(); }

  const Uv& uv(VertexHandle vh) const { return mesh_.property(uv_, vh); }
  Uv& uv(VertexHandle vh) { return mesh_.property(uv_, vh); }
  const Metric& metric(VertexHandle vh) const { return mesh_.property(metric_, vh); }
  Metric& metric(VertexHandle vh) { return mesh_.property(metric_, vh); }
  bool is_constrained(EdgeHandle eh) const { return mesh_.property(constrained_, eh) != 0; }
  void constrain(EdgeHandle eh) { mesh_.property(constrained_, eh) = 1; }

  /// Make room for `count` more vertices.
  void reserve(std::size_t count) { pool_.reserve(count); }

  /// Cut off the surplus elements and hand out the mesh, with its properties; nothing else may be
  /// called after that.
  std::unique_ptr<PolyMesh> release();

  /// Cut off the surplus elements.
  void shrink() { pool_.shrink(); }

  /// Renumber all elements along a Hilbert curve, except the first `fixed` vertices, which stay.
  ///
  /// Pays off before anything that visits every element at least once.
  /// Cost     O(n)
  /// Pre      shrink() has been called
  void sort_spatially(std::size_t fixed);

  // --- insertion ---

  Location locate(Uv p, FaceHandle start) {
    return surfmesh::locate(mesh_, uv_, p, start, random_, n_faces());
  }

  /// Collect the triangles that a point replaces: those around `location` that the rule selects and
  /// the point sees, in one piece.
  ///
  /// Pre      location.kind is Inside or OnEdge, and not on a constrained edge with two triangles
  template <class Rule>
  void find_cavity(Uv p, const Location& location, const Rule& rule, Cavity& cavity);

  /// Replace the cavity by the fan from p. The metric of the new vertex is unset.
  VertexHandle fill(const Cavity& cavity, Uv p) {
    const VertexHandle vh = fill_cavity(mesh_, pool_, cavity, constrained_);
    mesh_.property(uv_, vh) = p;
    mesh_.property(metric_, vh) = Metric();
    return vh;
  }

  /// Insert a point by the empty cavity.
  ///
  /// Returns  the new vertex; the old one if p is its position; an invalid handle if p lies
  ///          outside, behind a constrained edge, or on a constrained edge with two triangles
  /// Cost     O(1) with a near start; about 0.3 µs in spatial order
  template <class Rule>
  VertexHandle insert(Uv p, FaceHandle start, const Rule& rule);

  /// Insert a point by splitting its triangle (or edge) and swapping edges.
  /// Returns  as insert()
  template <class Rule>
  VertexHandle insert_by_swaps(Uv p, FaceHandle start, const Rule& rule);

  // --- edges ---

  /// True if the edge is inner, not constrained, and its quadrilateral strictly convex.
  bool can_flip(EdgeHandle eh) const;

  /// Put a new vertex on an inner edge, without any swap. Its metric is unset.
  /// Pre      the edge is not constrained; p lies on it, or sees all four sides around
  VertexHandle split_edge(EdgeHandle eh, Uv p) {
    const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
    seed_cavity({Location::Kind::OnEdge, mesh_.face_handle(heh), heh, VertexHandle()}, cavity_);
    return fill(cavity_, p);
  }

  void flip(EdgeHandle eh) { surfmesh::flip(mesh_, eh); }

  /// Merge the origin of a halfedge, an inner vertex, into its tip. The last vertex, edges and
  /// faces take over the numbers of the removed ones, so their handles change.
  /// Pre      the tip sees all triangles around the origin that do not have it as a corner
  void collapse(HalfedgeHandle heh);

  /// The halfedge from a to b; an invalid handle if they are not joined.
  HalfedgeHandle find_halfedge(VertexHandle a, VertexHandle b) const;

  /// Make the segment from a to b an edge, or a chain of edges through vertices exactly on it, and
  /// constrain it.
  ///
  /// By swaps of the edges that cross it.
  /// Throws   Geometry if it crosses a constrained edge, naming (u,v)
  /// Source   Sloan, A fast algorithm for generating constrained Delaunay triangulations (1993)
  void insert_constraint(VertexHandle a, VertexHandle b);

 private:
  TriangleVertices triangle_behind(HalfedgeHandle from_outside) const;
  bool sees_apex(Uv p, const TriangleVertices& triangle) const;
  template <class Rule>
  bool is_replaced(Uv p, HalfedgeHandle from_outside, const Rule& rule) const;
  void seed_cavity(const Location& location, Cavity& cavity);
  bool is_insertable(const Location& location) const;
  template <class Rule>
  void legalise(VertexHandle vh, const Rule& rule);
  HalfedgeHandle first_crossing(VertexHandle a, VertexHandle b) const;
  VertexHandle collect_crossings(VertexHandle a, VertexHandle b, std::vector<EdgeHandle>& crossed);
  void remove_crossings(VertexHandle a, VertexHandle b, std::vector<EdgeHandle>& crossed);
  bool crosses(EdgeHandle eh, VertexHandle a, VertexHandle b) const;

  std::unique_ptr<PolyMesh> owned_;  // OpenMesh's meshes cannot be moved
  PolyMesh& mesh_;
  UvHandle uv_;
  MetricHandle metric_;
  ConstrainedHandle constrained_;
  ElementPool pool_;
  RandomBits random_;
  Cavity cavity_;
  std::vector<HalfedgeHandle> stack_;
};

/// The triangle behind `from_outside`, its halfedge at the cavity; the apex comes last.
inline TriangleVertices DelaunayMesh::triangle_behind(HalfedgeHandle from_outside) const {
  return {mesh_.from_vertex_handle(from_outside), mesh_.to_vertex_handle(from_outside),
          mesh_.to_vertex_handle(mesh_.next_halfedge_handle(from_outside))};
}

/// True if p lies strictly left of the two sides of a triangle at its apex.
inline bool DelaunayMesh::sees_apex(Uv p, const TriangleVertices& triangle) const {
  const Uv apex = uv(triangle[2]);
  return orient2d(p, uv(triangle[1]), apex) > 0 && orient2d(p, apex, uv(triangle[0])) > 0;
}

/// True if the triangle behind an edge must be replaced, too. The rule comes first: it says no most
/// often. The hottest function of all: refine is 7 % slower if it is called and not inlined.
template <class Rule>
[[gnu::always_inline]] inline bool DelaunayMesh::is_replaced(Uv p, HalfedgeHandle from_outside,
                                                             const Rule& rule) const {
  if (mesh_.is_boundary(from_outside)) return false;
  const TriangleVertices triangle = triangle_behind(from_outside);
  return rule(mesh_, triangle, p) && !is_constrained(mesh_.edge_handle(from_outside)) &&
         sees_apex(p, triangle);
}

template <class Rule>
void DelaunayMesh::find_cavity(Uv p, const Location& location, const Rule& rule, Cavity& cavity) {
  // Depth first, counter-clockwise. As p sees every triangle strictly, none is met twice and the
  // rim comes out in order.
  seed_cavity(location, cavity);
  stack_.assign(cavity.rim.rbegin(), cavity.rim.rend());
  cavity.rim.clear();
  while (!stack_.empty()) {
    const HalfedgeHandle heh = stack_.back();
    stack_.pop_back();
    const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
    if (!is_replaced(p, opposite, rule)) {
      cavity.rim.push_back(heh);
      continue;
    }
    cavity.faces.push_back(mesh_.face_handle(opposite));
    cavity.inner_edges.push_back(mesh_.edge_handle(heh));
    const HalfedgeHandle next = mesh_.next_halfedge_handle(opposite);
    stack_.push_back(mesh_.next_halfedge_handle(next));
    stack_.push_back(next);
  }
}

template <class Rule>
VertexHandle DelaunayMesh::insert(Uv p, FaceHandle start, const Rule& rule) {
  const Location location = locate(p, start);
  if (location.kind == Location::Kind::OnVertex) return location.vertex;
  if (!is_insertable(location)) return VertexHandle();
  find_cavity(p, location, rule, cavity_);
  return fill(cavity_, p);
}

template <class Rule>
VertexHandle DelaunayMesh::insert_by_swaps(Uv p, FaceHandle start, const Rule& rule) {
  const Location location = locate(p, start);
  if (location.kind == Location::Kind::OnVertex) return location.vertex;
  if (!is_insertable(location)) return VertexHandle();
  seed_cavity(location, cavity_);
  const VertexHandle vh = fill(cavity_, p);
  legalise(vh, rule);
  return vh;
}

template <class Rule>
void DelaunayMesh::legalise(VertexHandle vh, const Rule& rule) {
  // Every swap adds an edge to vh, so this ends whatever the rule says.
  const Uv p = uv(vh);
  stack_.assign(cavity_.rim.begin(), cavity_.rim.end());
  while (!stack_.empty()) {
    const HalfedgeHandle heh = stack_.back();
    stack_.pop_back();
    const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
    if (!is_replaced(p, opposite, rule)) continue;
    const HalfedgeHandle next = mesh_.next_halfedge_handle(opposite);
    stack_.push_back(mesh_.next_halfedge_handle(next));
    stack_.push_back(next);
    surfmesh::flip(mesh_, mesh_.edge_handle(heh));
  }
}

}  // namespace surfmesh
