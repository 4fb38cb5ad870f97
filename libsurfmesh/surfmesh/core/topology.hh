// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {

// Only these operations and those of core/renumber.hh, core/face_editor.hh and core/close_slits.hh
// change the connectivity of a mesh. They work in place; the frequent ones are inlined. OpenMesh's
// own operations are compiled with assertions in Debian's library (a flip takes 218 ns instead of
// 26) and lose edge properties in a split. Properties after an operation:
//   flip            vertex, face: kept; edge, halfedge: those of the flipped edge are kept
//   collapse        kept; those of removed elements are lost, and the last elements take over their
//                   numbers with their own values
//   fill_cavity     vertex: new ones have their type's default, to be set by the caller;
//                   edge: those inside the cavity become spokes, surf:constrained is 0 there; both
//                   parts of a split boundary edge keep its surf:constrained;
//                   face: unspecified in the cavity

/// Elements that nothing refers to any more.
struct FreedElements {
  VertexHandle vertex;
  std::array<EdgeHandle, 3> edges;
  std::array<FaceHandle, 2> faces;
};

/// Hands out elements of a mesh that grows in bulk.
///
/// OpenMesh's new_vertex/edge/face resize every property array at each call; here the arrays are
/// resized for many vertices at a time and the surplus is cut off by shrink(). Between growth and
/// shrink() the mesh has surplus elements at the end of its arrays, which no halfedge refers to.
class ElementPool {
 public:
  explicit ElementPool(PolyMesh& mesh)
      : mesh_(mesh), vertices_(mesh.n_vertices()), edges_(mesh.n_edges()), faces_(mesh.n_faces()) {}

  /// Make room for `count` more vertices in all (three edges and two faces each).
  void reserve(std::size_t count) {
    mesh_.resize(vertices_ + count, edges_ + 3 * count, faces_ + 2 * count);
  }

  /// Make sure that one more vertex can be inserted without another resize.
  ///
  /// Cost     O(1) amortised, because std::vector's memory grows geometrically. Also resizing by a
  ///          share of the mesh would fill that share for a single vertex
  void prepare_insertion() {
    if (vertices_ + 1 > mesh_.n_vertices() || edges_ + 3 > mesh_.n_edges() ||
        faces_ + 2 > mesh_.n_faces()) {
      reserve(kGrowth);
    }
  }

  VertexHandle next_vertex() { return VertexHandle(static_cast<int>(vertices_++)); }
  EdgeHandle next_edge() { return EdgeHandle(static_cast<int>(edges_++)); }
  FaceHandle next_face() { return FaceHandle(static_cast<int>(faces_++)); }

  /// Give the numbers of freed elements to the last elements. Calls `moved(from, to)` with the
  /// handles of each one that moves, for its properties.
  template <class Moved>
  void remove(FreedElements freed, Moved moved);

  std::size_t n_vertices() const { return vertices_; }
  std::size_t n_edges() const { return edges_; }
  std::size_t n_faces() const { return faces_; }

  /// Cut off the surplus.
  void shrink() { mesh_.resize(vertices_, edges_, faces_); }

 private:
  static constexpr std::size_t kGrowth = 64;  ///< vertices for which room is made at once

  PolyMesh& mesh_;
  std::size_t vertices_;
  std::size_t edges_;
  std::size_t faces_;
};

/// What had to be separated because a half-edge mesh cannot represent it.
struct Separation {
  /// For each vertex beyond the given count, the vertex that it copies.
  std::vector<int> copied;
  std::size_t cut_edges = 0;  ///< sides that are not glued although other faces share them
};

/// In place of a twin: the side is glued to none, whatever its vertices are.
inline constexpr int kOpenSide = -2;

/// Build the connectivity of a mesh without elements, in bulk.
///
/// Two triangles are glued where one has the edge (a,b) and the other (b,a), and only if no third
/// triangle has that edge; otherwise the edge is cut: it stays open on both. If the triangles at a
/// vertex do not form one fan (surfaces touch there, or edges were left open), each fan but the
/// first gets a copy of the vertex. Where two sides that were cut then still lie between the same
/// two vertices, they are glued after all. Edges with given twins are numbered first, in the order
/// of the triangles; the others follow, ordered by their vertices, but for the last ones, which
/// take the numbers of edges that are glued after all.
///
/// `twins` holds what is known already. For each side (3 × triangle + corner at its origin) it
/// names the side it is glued to, which has the same two vertices and names it in turn; -1 leaves
/// the decision to the vertices, kOpenSide leaves the side open. Empty if nothing is known.
///
/// Cost     O(n) for sides with twins; O(n log n) for others
/// Pre      mesh without elements; indices in [0, vertex_count), three different ones a triangle
Separation build_triangles(PolyMesh& mesh, std::size_t vertex_count,
                           const std::vector<std::array<int, 3>>& triangles,
                           std::span<const int> twins = {});

/// At which corner the halfedge of a face starts, from which OpenMesh goes around the face.
enum class FirstSide {
  FromFirstCorner,  ///< as build_triangles; ranges of vertices begin at the second corner
  ToFirstCorner     ///< ranges of vertices begin at the first corner, as files have them
};

/// Build the connectivity of a mesh of faces of any size, as build_triangles does. `twins` has an
/// entry for each corner of the list.
///
/// Cost     as build_triangles where all faces are triangles
/// Pre      no face has a vertex twice
Separation build_faces(PolyMesh& mesh, std::size_t vertex_count, const FaceList& faces,
                       FirstSide first_side, std::span<const int> twins = {});

/// Swap the diagonal of the two triangles at an inner edge. The caller makes sure that the four
/// points are in convex position and that the new edge does not exist.
inline void flip(PolyMesh& mesh, EdgeHandle eh) {
  const HalfedgeHandle a0 = mesh.halfedge_handle(eh, 0);
  const HalfedgeHandle b0 = mesh.halfedge_handle(eh, 1);
  const HalfedgeHandle a1 = mesh.next_halfedge_handle(a0);
  const HalfedgeHandle a2 = mesh.next_halfedge_handle(a1);
  const HalfedgeHandle b1 = mesh.next_halfedge_handle(b0);
  const HalfedgeHandle b2 = mesh.next_halfedge_handle(b1);
  const VertexHandle va0 = mesh.to_vertex_handle(a0);
  const VertexHandle va1 = mesh.to_vertex_handle(a1);
  const VertexHandle vb0 = mesh.to_vertex_handle(b0);
  const VertexHandle vb1 = mesh.to_vertex_handle(b1);
  const FaceHandle fa = mesh.face_handle(a0);
  const FaceHandle fb = mesh.face_handle(b0);

  mesh.set_vertex_handle(a0, va1);
  mesh.set_vertex_handle(b0, vb1);
  mesh.set_next_halfedge_handle(a0, a2);
  mesh.set_next_halfedge_handle(a2, b1);
  mesh.set_next_halfedge_handle(b1, a0);
  mesh.set_next_halfedge_handle(b0, b2);
  mesh.set_next_halfedge_handle(b2, a1);
  mesh.set_next_halfedge_handle(a1, b0);
  mesh.set_face_handle(a1, fb);
  mesh.set_face_handle(b1, fa);
  mesh.set_halfedge_handle(fa, a0);
  mesh.set_halfedge_handle(fb, b0);
  if (mesh.halfedge_handle(va0) == b0) mesh.set_halfedge_handle(va0, a1);
  if (mesh.halfedge_handle(vb0) == a0) mesh.set_halfedge_handle(vb0, b1);
}

namespace detail {

/// Give an element the number of another one that nothing refers to.
void renumber_element(PolyMesh& mesh, VertexHandle from, VertexHandle to);
void renumber_element(PolyMesh& mesh, EdgeHandle from, EdgeHandle to);
void renumber_element(PolyMesh& mesh, FaceHandle from, FaceHandle to);

}  // namespace detail

template <class Moved>
void ElementPool::remove(FreedElements freed, Moved moved) {
  const auto take = [&](auto hole, std::size_t& count) {
    const decltype(hole) last(static_cast<int>(--count));
    if (last == hole) return;
    detail::renumber_element(mesh_, last, hole);
    moved(last, hole);
  };
  // The largest first: then the last element is never a freed one.
  std::sort(freed.edges.rbegin(), freed.edges.rend());
  std::sort(freed.faces.rbegin(), freed.faces.rend());
  take(freed.vertex, vertices_);
  for (const EdgeHandle eh : freed.edges) take(eh, edges_);
  for (const FaceHandle fh : freed.faces) take(fh, faces_);
}

/// Merge the origin of a halfedge, an inner vertex, into its tip. The two triangles at the edge are
/// removed; of each, the side at the tip stays, with its properties.
///
/// Pre      the new triangles are valid: no vertex around the origin but the two apexes is joined
///          to the tip
/// Returns  the elements to remove (see ElementPool::remove)
FreedElements collapse(PolyMesh& mesh, HalfedgeHandle heh);

/// Triangles that are to be replaced by the fan from one new vertex.
struct Cavity {
  /// Halfedges of the cavity's triangles along its border, counter-clockwise and end to end.
  /// With a split edge, from its tip to its origin, without the edge itself.
  std::vector<HalfedgeHandle> rim;
  std::vector<EdgeHandle> inner_edges;
  std::vector<FaceHandle> faces;
  /// Inner halfedge of the boundary edge on which the new vertex lies; invalid for none.
  HalfedgeHandle split;

  void clear() {
    rim.clear();
    inner_edges.clear();
    faces.clear();
    split.invalidate();
  }
};

namespace detail {

/// Hands out the cavity's old edges and faces first, then new ones.
class CavityElements {
 public:
  CavityElements(PolyMesh& mesh, ElementPool& pool, const Cavity& cavity)
      : mesh_(mesh), pool_(pool), cavity_(cavity) {}

  /// An edge between `from` and `to`; its first halfedge points to `to`.
  HalfedgeHandle connect(VertexHandle from, VertexHandle to) {
    const EdgeHandle eh =
        edge_ < cavity_.inner_edges.size() ? cavity_.inner_edges[edge_++] : pool_.next_edge();
    const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
    mesh_.set_vertex_handle(heh, to);
    mesh_.set_vertex_handle(mesh_.halfedge_handle(eh, 1), from);
    return heh;
  }

  FaceHandle next_face() {
    return face_ < cavity_.faces.size() ? cavity_.faces[face_++] : pool_.next_face();
  }

 private:
  PolyMesh& mesh_;
  ElementPool& pool_;
  const Cavity& cavity_;
  std::size_t edge_ = 0;
  std::size_t face_ = 0;
};

/// Cut the boundary edge of `inner` at vh. `inner` then leads from vh to its old tip.
/// Returns the inner halfedge of the part from the old origin to vh.
inline HalfedgeHandle split_boundary_edge(PolyMesh& mesh, ElementPool& pool, HalfedgeHandle inner,
                                          VertexHandle vh) {
  const HalfedgeHandle outer = mesh.opposite_halfedge_handle(inner);
  const VertexHandle origin = mesh.to_vertex_handle(outer);
  const HalfedgeHandle after = mesh.next_halfedge_handle(outer);
  const EdgeHandle part = pool.next_edge();
  const HalfedgeHandle part_inner = mesh.halfedge_handle(part, 0);
  const HalfedgeHandle part_outer = mesh.halfedge_handle(part, 1);
  mesh.set_vertex_handle(part_inner, vh);
  mesh.set_vertex_handle(part_outer, origin);
  mesh.set_boundary(part_outer);
  mesh.set_vertex_handle(outer, vh);
  mesh.set_next_halfedge_handle(outer, part_outer);
  mesh.set_next_halfedge_handle(part_outer, after);
  mesh.set_halfedge_handle(vh, part_outer);
  return part_inner;
}

}  // namespace detail

/// Replace the triangles of a cavity by the fan from a new vertex to its rim.
///
/// Nothing is deleted: the fan has two triangles and three edges more than the cavity (one and two
/// where a boundary edge is split), and old ones are reused first.
///
/// Cost     O(size of the rim), no allocation after ElementPool::prepare_insertion
/// Pre      the rim is as Cavity says; `constrained` is the mesh's surf:constrained
inline VertexHandle fill_cavity(PolyMesh& mesh, ElementPool& pool, const Cavity& cavity,
                                decltype(keys::edge_constrained)::Handle constrained) {
  pool.prepare_insertion();
  const VertexHandle vh = pool.next_vertex();
  detail::CavityElements elements(mesh, pool, cavity);

  // `spoke` leads from vh to the origin of the next rim halfedge.
  HalfedgeHandle spoke, last;
  if (cavity.split.is_valid()) {
    last = detail::split_boundary_edge(mesh, pool, cavity.split, vh);
    mesh.property(constrained, mesh.edge_handle(last)) =
        mesh.property(constrained, mesh.edge_handle(cavity.split));
    spoke = cavity.split;
  } else {
    spoke = elements.connect(vh, mesh.from_vertex_handle(cavity.rim.front()));
    mesh.property(constrained, mesh.edge_handle(spoke)) = 0;
    mesh.set_halfedge_handle(vh, spoke);
    last = mesh.opposite_halfedge_handle(spoke);
  }

  for (std::size_t i = 0; i < cavity.rim.size(); ++i) {
    const HalfedgeHandle base = cavity.rim[i];
    const VertexHandle origin = mesh.from_vertex_handle(base);
    HalfedgeHandle back = last;
    if (i + 1 < cavity.rim.size()) {
      back = mesh.opposite_halfedge_handle(elements.connect(vh, mesh.to_vertex_handle(base)));
      mesh.property(constrained, mesh.edge_handle(back)) = 0;
    }
    const FaceHandle fh = elements.next_face();
    mesh.set_next_halfedge_handle(spoke, base);
    mesh.set_next_halfedge_handle(base, back);
    mesh.set_next_halfedge_handle(back, spoke);
    mesh.set_face_handle(spoke, fh);
    mesh.set_face_handle(base, fh);
    mesh.set_face_handle(back, fh);
    mesh.set_halfedge_handle(fh, base);
    if (!mesh.is_boundary(mesh.halfedge_handle(origin))) mesh.set_halfedge_handle(origin, base);
    spoke = mesh.opposite_halfedge_handle(back);
  }
  return vh;
}

}  // namespace surfmesh
