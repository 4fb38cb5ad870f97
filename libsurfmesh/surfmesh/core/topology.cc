// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/topology.hh"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "surfmesh/core/close_slits.hh"

namespace surfmesh {
namespace {

/// Corners of triangles, numbered 3 × triangle + corner. A side has the number of the corner at its
/// origin.
class TriangleCorners {
 public:
  TriangleCorners(std::span<const int> vertices, FirstSide first_side)
      : vertices_(vertices), leading_(first_side == FirstSide::FromFirstCorner ? 0 : 2) {}

  std::size_t face_count() const { return vertices_.size() / 3; }
  std::size_t count() const { return vertices_.size(); }
  std::size_t first(std::size_t face) const { return 3 * face; }
  int vertex(std::size_t corner) const { return vertices_[corner]; }
  std::size_t next(std::size_t corner) const { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  /// The side whose halfedge the face gets.
  std::size_t leading_side(std::size_t face) const { return 3 * face + leading_; }

 private:
  std::span<const int> vertices_;
  std::size_t leading_;
};

/// Corners of faces of any size, in the order of the faces.
class PolygonCorners {
 public:
  PolygonCorners(const FaceList& faces, FirstSide first_side)
      : faces_(faces), first_side_(first_side), next_(faces.corner_count()) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t c = first(f); c < first(f + 1); ++c) next_[c] = c + 1;
      next_[first(f + 1) - 1] = first(f);
    }
  }

  std::size_t face_count() const { return faces_.size(); }
  std::size_t count() const { return faces_.corner_count(); }
  std::size_t first(std::size_t face) const { return faces_.first_corner(face); }
  int vertex(std::size_t corner) const { return faces_.vertex(corner); }
  std::size_t next(std::size_t corner) const { return next_[corner]; }
  std::size_t leading_side(std::size_t face) const {
    return first_side_ == FirstSide::FromFirstCorner ? first(face) : first(face + 1) - 1;
  }

 private:
  const FaceList& faces_;
  FirstSide first_side_;
  std::vector<std::size_t> next_;
};

/// One side of a face, filed under the smaller of its vertices.
struct Side {
  int larger;      ///< the larger of its two vertices
  int index;       ///< of the corner at its origin
  bool is_rising;  ///< leads from the smaller to the larger vertex
};

/// Some sides sorted by their smaller, then by their larger vertex.
class SideTable {
 public:
  template <class Corners>
  SideTable(std::size_t vertex_count, const Corners& corners, const std::vector<int>& sides)
      : first_(vertex_count + 1, 0), sides_(sides.size()) {
    const auto ends = [&corners](int side) {
      const auto c = static_cast<std::size_t>(side);
      return std::pair(corners.vertex(c), corners.vertex(corners.next(c)));
    };
    const auto smaller = [](std::pair<int, int> side) {
      return static_cast<std::size_t>(std::min(side.first, side.second));
    };
    for (const int side : sides) ++first_[smaller(ends(side)) + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const int side : sides) {
      const auto [a, b] = ends(side);
      sides_[next[smaller({a, b})]++] = {std::max(a, b), side, a < b};
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
      std::sort(begin(v), begin(v + 1), [](const Side& a, const Side& b) {
        return a.larger != b.larger ? a.larger < b.larger : a.index < b.index;
      });
    }
  }

  /// Call `visit(first, last)` for the sides of every pair of vertices.
  template <class Visit>
  void for_each_edge(Visit visit) {
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      for (auto it = begin(v); it != begin(v + 1);) {
        auto last = it;
        while (last != begin(v + 1) && last->larger == it->larger) ++last;
        visit(it, last);
        it = last;
      }
    }
  }

 private:
  std::vector<Side>::iterator begin(std::size_t v) {
    return sides_.begin() + static_cast<std::ptrdiff_t>(first_[v]);
  }

  std::vector<std::uint32_t> first_;
  std::vector<Side> sides_;
};

/// Give every side of every face its halfedge; glued sides get the two of one edge.
template <class Corners>
class HalfedgeAssignment {
 public:
  HalfedgeAssignment(PolyMesh& mesh, const Corners& corners)
      : mesh_(mesh), corners_(corners), halfedge_of_(corners.count()) {}

  HalfedgeHandle of(std::size_t side) const { return halfedge_of_[side]; }

  std::size_t edge_count() const { return count_; }

  /// Glue sides to their twins, those without one (-1, or no twins at all) by their vertices.
  /// Returns  the edges of sides left open though others have their vertices, in rising order
  std::vector<EdgeHandle> assign(std::size_t vertex_count, std::span<const int> twins) {
    std::vector<int> others;
    for (std::size_t side = 0; side < halfedge_of_.size(); ++side) {
      const int twin = twins.empty() ? -1 : twins[side];
      if (twin == kOpenSide) {
        give(static_cast<int>(side), 2 * count_++);
      } else if (twin < 0) {
        others.push_back(static_cast<int>(side));
      } else if (twin > static_cast<int>(side)) {
        glue(static_cast<int>(side), twin);
      }
    }
    std::vector<EdgeHandle> cut;
    SideTable(vertex_count, corners_, others).for_each_edge([&](auto first, auto last) {
      if (last - first == 2 && first->is_rising != first[1].is_rising) {
        glue(first->index, first[1].index);
        return;
      }
      const bool is_cut = last - first > 1;
      for (; first != last; ++first) {
        if (is_cut) cut.emplace_back(static_cast<int>(count_));
        give(first->index, 2 * count_++);
      }
    });
    return cut;
  }

  void set_vertices() {
    for (std::size_t side = 0; side < halfedge_of_.size(); ++side) {
      const HalfedgeHandle heh = halfedge_of_[side];
      mesh_.set_vertex_handle(heh, VertexHandle(corners_.vertex(corners_.next(side))));
      mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(heh),
                              VertexHandle(corners_.vertex(side)));
    }
  }

 private:
  void glue(int side, int twin) {
    give(side, 2 * count_);
    give(twin, 2 * count_ + 1);
    ++count_;
  }

  void give(int side, std::size_t halfedge) {
    halfedge_of_[static_cast<std::size_t>(side)] = HalfedgeHandle(static_cast<int>(halfedge));
  }

  PolyMesh& mesh_;
  const Corners& corners_;
  std::vector<HalfedgeHandle> halfedge_of_;
  std::size_t count_ = 0;
};

/// The open halfedge that follows `outer`: turn around its tip through the faces there.
HalfedgeHandle next_open_halfedge(const PolyMesh& mesh, HalfedgeHandle outer) {
  HalfedgeHandle heh = mesh.opposite_halfedge_handle(outer);
  do {
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (!mesh.is_boundary(heh));
  return heh;
}

void link_open_halfedges(PolyMesh& mesh) {
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    const HalfedgeHandle heh(static_cast<int>(i));
    if (!mesh.is_boundary(heh)) continue;
    const HalfedgeHandle next = next_open_halfedge(mesh, heh);
    mesh.set_next_halfedge_handle(heh, next);
    mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
  }
}

/// Gives every fan of faces around a vertex a vertex of its own.
class FanSeparation {
 public:
  explicit FanSeparation(PolyMesh& mesh)
      : mesh_(mesh), is_seen_(mesh.n_halfedges(), 0), first_fan_(mesh.n_vertices()) {}

  /// Pre      `of(side)` is the halfedge that leaves the corner `side`
  /// Returns  the vertex that each new one is a copy of
  template <class HalfedgeOf>
  std::vector<int> run(std::size_t corner_count, HalfedgeOf of) {
    std::vector<HalfedgeHandle> further_fans;
    for (std::size_t corner = 0; corner < corner_count; ++corner) {
      const HalfedgeHandle heh = of(corner);
      if (is_seen_[index(heh)]) continue;
      for_each_spoke(heh, [this](HalfedgeHandle spoke) { is_seen_[index(spoke)] = 1; });
      HalfedgeHandle& first = first_fan_[index(mesh_.from_vertex_handle(heh))];
      if (first.is_valid()) {
        further_fans.push_back(heh);
      } else {
        first = heh;
      }
    }
    return duplicate(further_fans);
  }

 private:
  template <class Visit>
  void for_each_spoke(HalfedgeHandle start, Visit visit) {
    HalfedgeHandle heh = start;
    do {
      visit(heh);
      heh = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(heh));
    } while (heh != start);
  }

  std::vector<int> duplicate(const std::vector<HalfedgeHandle>& fans) {
    std::vector<int> copied;
    std::size_t count = mesh_.n_vertices();
    mesh_.resize(count + fans.size(), mesh_.n_edges(), mesh_.n_faces());
    for (const HalfedgeHandle heh : fans) {
      const VertexHandle old = mesh_.from_vertex_handle(heh);
      copied.push_back(old.idx());
      give(heh, VertexHandle(static_cast<int>(count++)));
      give(first_fan_[index(old)], old);
    }
    return copied;
  }

  /// Let a fan be that of the vertex, whose own halfedge is the open one if there is one.
  void give(HalfedgeHandle fan, VertexHandle vh) {
    mesh_.set_halfedge_handle(vh, fan);
    for_each_spoke(fan, [&](HalfedgeHandle spoke) {
      mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(spoke), vh);
      if (mesh_.is_boundary(spoke)) mesh_.set_halfedge_handle(vh, spoke);
    });
  }

  PolyMesh& mesh_;
  std::vector<char> is_seen_;
  std::vector<HalfedgeHandle> first_fan_;  ///< by vertex
};

template <class Corners>
Separation build_connectivity(PolyMesh& mesh, std::size_t vertex_count, const Corners& corners,
                              std::span<const int> twins) {
  HalfedgeAssignment<Corners> halfedges(mesh, corners);
  const std::vector<EdgeHandle> cut = halfedges.assign(vertex_count, twins);
  mesh.resize(vertex_count, halfedges.edge_count(), corners.face_count());
  halfedges.set_vertices();
  for (std::size_t f = 0; f < corners.face_count(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    for (std::size_t c = corners.first(f); c < corners.first(f + 1); ++c) {
      const HalfedgeHandle heh = halfedges.of(c);
      mesh.set_next_halfedge_handle(heh, halfedges.of(corners.next(c)));
      mesh.set_face_handle(heh, fh);
      mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
    }
    mesh.set_halfedge_handle(fh, halfedges.of(corners.leading_side(f)));
  }
  link_open_halfedges(mesh);
  Separation separation;
  separation.copied =
      FanSeparation(mesh).run(corners.count(), [&](std::size_t c) { return halfedges.of(c); });
  separation.cut_edges = cut.size() - 2 * close_slits(mesh, cut);
  return separation;
}

/// Put `heir` into the place of a halfedge between the same vertices.
void replace_halfedge(PolyMesh& mesh, HalfedgeHandle heh, HalfedgeHandle heir) {
  const FaceHandle fh = mesh.face_handle(heh);
  mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(heh), heir);
  mesh.set_next_halfedge_handle(heir, mesh.next_halfedge_handle(heh));
  mesh.set_face_handle(heir, fh);
  mesh.set_halfedge_handle(fh, heir);
}

/// Let a vertex refer to `spoke` if it refers to `freed`.
void replace_spoke(PolyMesh& mesh, VertexHandle vh, HalfedgeHandle freed, HalfedgeHandle spoke) {
  if (mesh.halfedge_handle(vh) == freed) mesh.set_halfedge_handle(vh, spoke);
}

}  // namespace

FreedElements collapse(PolyMesh& mesh, HalfedgeHandle heh) {
  const HalfedgeHandle back = mesh.opposite_halfedge_handle(heh);
  const HalfedgeHandle left = mesh.next_halfedge_handle(heh);          // tip to left apex
  const HalfedgeHandle left_gone = mesh.next_halfedge_handle(left);    // left apex to origin
  const HalfedgeHandle right_gone = mesh.next_halfedge_handle(back);   // origin to right apex
  const HalfedgeHandle right = mesh.next_halfedge_handle(right_gone);  // right apex to tip
  const VertexHandle origin = mesh.to_vertex_handle(back), tip = mesh.to_vertex_handle(heh);
  const FreedElements freed = {
      origin,
      {mesh.edge_handle(heh), mesh.edge_handle(left_gone), mesh.edge_handle(right_gone)},
      {mesh.face_handle(heh), mesh.face_handle(back)}};
  HalfedgeHandle spoke = heh;
  do {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(spoke), tip);
    spoke = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
  } while (spoke != heh);
  replace_spoke(mesh, tip, back, left);
  replace_spoke(mesh, mesh.to_vertex_handle(left), left_gone, mesh.opposite_halfedge_handle(left));
  replace_spoke(mesh, mesh.from_vertex_handle(right), mesh.opposite_halfedge_handle(right_gone),
                right);
  replace_halfedge(mesh, mesh.opposite_halfedge_handle(left_gone), left);
  replace_halfedge(mesh, mesh.opposite_halfedge_handle(right_gone), right);
  return freed;
}

namespace detail {

void renumber_element(PolyMesh& mesh, VertexHandle from, VertexHandle to) {
  const HalfedgeHandle start = mesh.halfedge_handle(from);
  HalfedgeHandle heh = start;
  do {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(heh), to);
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
  mesh.set_halfedge_handle(to, start);
}

void renumber_element(PolyMesh& mesh, EdgeHandle from, EdgeHandle to) {
  for (const unsigned k : {0u, 1u}) {
    const HalfedgeHandle old = mesh.halfedge_handle(from, k), heh = mesh.halfedge_handle(to, k);
    const VertexHandle origin = mesh.from_vertex_handle(old);
    const FaceHandle fh = mesh.face_handle(old);
    mesh.set_vertex_handle(heh, mesh.to_vertex_handle(old));
    mesh.set_face_handle(heh, fh);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(old), heh);
    mesh.set_next_halfedge_handle(heh, mesh.next_halfedge_handle(old));
    if (fh.is_valid() && mesh.halfedge_handle(fh) == old) mesh.set_halfedge_handle(fh, heh);
    if (mesh.halfedge_handle(origin) == old) mesh.set_halfedge_handle(origin, heh);
  }
}

void renumber_element(PolyMesh& mesh, FaceHandle from, FaceHandle to) {
  const HalfedgeHandle start = mesh.halfedge_handle(from);
  HalfedgeHandle heh = start;
  do {
    mesh.set_face_handle(heh, to);
    heh = mesh.next_halfedge_handle(heh);
  } while (heh != start);
  mesh.set_halfedge_handle(to, start);
}

}  // namespace detail

Separation build_triangles(PolyMesh& mesh, std::size_t vertex_count,
                           const std::vector<std::array<int, 3>>& triangles,
                           std::span<const int> twins) {
  const std::span<const int> vertices(triangles.empty() ? nullptr : triangles.front().data(),
                                      3 * triangles.size());
  return build_connectivity(mesh, vertex_count,
                            TriangleCorners(vertices, FirstSide::FromFirstCorner), twins);
}

Separation build_faces(PolyMesh& mesh, std::size_t vertex_count, const FaceList& faces,
                       FirstSide first_side, std::span<const int> twins) {
  if (faces.has_only_triangles()) {
    return build_connectivity(mesh, vertex_count, TriangleCorners(faces.vertices(), first_side),
                              twins);
  }
  return build_connectivity(mesh, vertex_count, PolygonCorners(faces, first_side), twins);
}

}  // namespace surfmesh
