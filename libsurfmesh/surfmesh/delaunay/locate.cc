// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/locate.hh"

#include <cmath>

#include "surfmesh/geometry/predicates.hh"

namespace surfmesh {
namespace {

class Walk {
 public:
  Walk(const PolyMesh& mesh, decltype(keys::vertex_uv)::Handle uv, Uv p)
      : mesh_(mesh), uv_(uv), p_(p) {}

  /// Sign of the side of `heh` on which p lies: 1 left, where its triangle is.
  int side(HalfedgeHandle heh) const {
    return orient2d(mesh_.property(uv_, mesh_.from_vertex_handle(heh)),
                    mesh_.property(uv_, mesh_.to_vertex_handle(heh)), p_);
  }

  /// Tell where in a triangle that contains it p lies.
  Location classify(FaceHandle fh) const {
    const HalfedgeHandle a = mesh_.halfedge_handle(fh);
    const HalfedgeHandle b = mesh_.next_halfedge_handle(a);
    const HalfedgeHandle c = mesh_.next_halfedge_handle(b);
    HalfedgeHandle edge;
    for (const HalfedgeHandle heh : {a, b, c}) {
      const VertexHandle tip = mesh_.to_vertex_handle(heh);
      if (mesh_.property(uv_, tip) == p_) return {Location::Kind::OnVertex, fh, heh, tip};
      if (side(heh) == 0) edge = heh;
    }
    return {edge.is_valid() ? Location::Kind::OnEdge : Location::Kind::Inside, fh, edge,
            VertexHandle()};
  }

  bool contains(FaceHandle fh) const {
    HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = mesh_.next_halfedge_handle(heh)) {
      if (side(heh) < 0) return false;
    }
    return true;
  }

  /// The open edge of a triangle that p lies behind; invalid if there is none.
  HalfedgeHandle open_edge_before(FaceHandle fh) const {
    HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = mesh_.next_halfedge_handle(heh)) {
      if (mesh_.is_boundary(mesh_.opposite_halfedge_handle(heh)) && side(heh) < 0) return heh;
    }
    return HalfedgeHandle();
  }

 private:
  const PolyMesh& mesh_;
  decltype(keys::vertex_uv)::Handle uv_;
  Uv p_;
};

Location search_all(const Walk& walk, FaceHandle last, std::size_t face_count) {
  Location outside{Location::Kind::Outside, last, HalfedgeHandle(), VertexHandle()};
  for (std::size_t i = 0; i < face_count; ++i) {
    const FaceHandle fh(static_cast<int>(i));
    if (walk.contains(fh)) return walk.classify(fh);
    if (outside.edge.is_valid()) continue;
    outside.edge = walk.open_edge_before(fh);
    if (outside.edge.is_valid()) outside.face = fh;
  }
  return outside;
}

/// A walk across n triangles of a reasonable mesh takes about √n steps; this leaves room for
/// stretched ones before the search of all of them, which costs n.
std::size_t step_limit(std::size_t face_count) {
  return 100 + 20 * static_cast<std::size_t>(std::sqrt(static_cast<double>(face_count)));
}

}  // namespace

Location locate(const PolyMesh& mesh, decltype(keys::vertex_uv)::Handle uv, Uv p, FaceHandle start,
                RandomBits& random, std::size_t face_count) {
  const Walk walk(mesh, uv, p);
  HalfedgeHandle entry = mesh.halfedge_handle(start);
  bool is_first = true;
  for (std::size_t steps = step_limit(face_count); steps > 0; --steps) {
    // Ask the side through which the walk came only in the first triangle.
    HalfedgeHandle a = mesh.next_halfedge_handle(entry);
    HalfedgeHandle b = mesh.next_halfedge_handle(a);
    if (random.next() & 1u) std::swap(a, b);
    HalfedgeHandle exit;
    const int side_a = walk.side(a), side_b = side_a < 0 ? 0 : walk.side(b);
    // The side it came through has the point on its left.
    const int side_entry = is_first && side_a >= 0 && side_b >= 0 ? walk.side(entry) : 1;
    if (side_a < 0) {
      exit = a;
    } else if (side_b < 0) {
      exit = b;
    } else if (side_entry < 0) {
      exit = entry;
    } else if (side_a > 0 && side_b > 0 && side_entry > 0) {
      return {Location::Kind::Inside, mesh.face_handle(entry), HalfedgeHandle(), VertexHandle()};
    } else {
      return walk.classify(mesh.face_handle(entry));
    }
    is_first = false;
    const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(exit);
    if (mesh.is_boundary(opposite)) {
      return {Location::Kind::Outside, mesh.face_handle(exit), exit, VertexHandle()};
    }
    entry = opposite;
  }
  return search_all(walk, mesh.face_handle(entry), face_count);
}

}  // namespace surfmesh
