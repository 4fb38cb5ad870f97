// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/topology.hh"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace surfmesh {
namespace {

/// Corners of triangles, numbered 3 × triangle + corner. A side has the number of the corner at its
/// origin.
class TriangleCorners {
 public:
  explicit TriangleCorners(const std::vector<std::array<int, 3>>& triangles)
      : triangles_(triangles) {}

  std::size_t face_count() const { return triangles_.size(); }
  std::size_t count() const { return 3 * triangles_.size(); }
  std::size_t first(std::size_t face) const { return 3 * face; }
  int vertex(std::size_t corner) const { return triangles_[corner / 3][corner % 3]; }
  std::size_t next(std::size_t corner) const { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  /// The side whose halfedge the face gets.
  std::size_t leading_side(std::size_t face) const { return 3 * face; }

 private:
  const std::vector<std::array<int, 3>>& triangles_;
};

/// Corners of faces of any size, in the order of the faces.
class PolygonCorners {
 public:
  explicit PolygonCorners(const FaceList& faces) : faces_(faces), next_(faces.corner_count()) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t c = first(f); c < first(f + 1); ++c) next_[c] = c + 1;
      next_[leading_side(f)] = first(f);
    }
  }

  std::size_t face_count() const { return faces_.size(); }
  std::size_t count() const { return faces_.corner_count(); }
  std::size_t first(std::size_t face) const { return faces_.first_corner(face); }
  int vertex(std::size_t corner) const { return faces_.vertex(corner); }
  std::size_t next(std::size_t corner) const { return next_[corner]; }

  /// The last side: OpenMesh lists the vertices of a face from the tip of its halfedge on.
  std::size_t leading_side(std::size_t face) const { return first(face + 1) - 1; }

 private:
  const FaceList& faces_;
  std::vector<std::size_t> next_;
};

/// One side of a face, filed under the smaller of its vertices.
struct Side {
  int larger;      ///< the larger of its two vertices
  int index;       ///< of the corner at its origin
  bool is_rising;  ///< leads from the smaller to the larger vertex
};

/// Sides of all faces sorted by their smaller, then by their larger vertex.
class SideTable {
 public:
  template <class Corners>
  SideTable(std::size_t vertex_count, const Corners& corners)
      : first_(vertex_count + 1, 0), sides_(corners.count()) {
    const auto smaller = [&corners](std::size_t c) {
      return static_cast<std::size_t>(std::min(corners.vertex(c), corners.vertex(corners.next(c))));
    };
    for (std::size_t c = 0; c < corners.count(); ++c) ++first_[smaller(c) + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t c = 0; c < corners.count(); ++c) {
      const int a = corners.vertex(c), b = corners.vertex(corners.next(c));
      sides_[next[smaller(c)]++] = {std::max(a, b), static_cast<int>(c), a < b};
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

  std::vector<std::size_t> first_;
  std::vector<Side> sides_;
};

/// Give every side of every face its halfedge; glued sides get the two of one edge.
template <class Mesh, class Corners>
class HalfedgeAssignment {
 public:
  HalfedgeAssignment(Mesh& mesh, const Corners& corners)
      : mesh_(mesh), corners_(corners), halfedge_of_(corners.count()) {}

  HalfedgeHandle of(std::size_t side) const { return halfedge_of_[side]; }

  std::size_t edge_count() const { return count_; }

  void assign(SideTable& table) {
    table.for_each_edge([this](auto first, auto last) {
      if (last - first == 2 && first->is_rising != first[1].is_rising) {
        give(first->index, 2 * count_);
        give(first[1].index, 2 * count_ + 1);
        ++count_;
        return;
      }
      for (; first != last; ++first) give(first->index, 2 * count_++);
    });
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
  void give(int side, std::size_t halfedge) {
    halfedge_of_[static_cast<std::size_t>(side)] = HalfedgeHandle(static_cast<int>(halfedge));
  }

  Mesh& mesh_;
  const Corners& corners_;
  std::vector<HalfedgeHandle> halfedge_of_;
  std::size_t count_ = 0;
};

/// The open halfedge that follows `outer`: turn around its tip through the faces there.
template <class Mesh>
HalfedgeHandle next_open_halfedge(const Mesh& mesh, HalfedgeHandle outer) {
  HalfedgeHandle heh = mesh.opposite_halfedge_handle(outer);
  do {
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (!mesh.is_boundary(heh));
  return heh;
}

template <class Mesh>
void link_open_halfedges(Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.n_halfedges(); ++i) {
    const HalfedgeHandle heh(static_cast<int>(i));
    if (!mesh.is_boundary(heh)) continue;
    const HalfedgeHandle next = next_open_halfedge(mesh, heh);
    mesh.set_next_halfedge_handle(heh, next);
    mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
  }
}

/// Corners of faces, joined where they belong to one fan.
class CornerUnion {
 public:
  explicit CornerUnion(std::size_t count) : parents_(count) {
    for (std::size_t i = 0; i < count; ++i) parents_[i] = static_cast<int>(i);
  }

  int root(int corner) {
    while (parent(corner) != corner) {
      parent(corner) = parent(parent(corner));
      corner = parent(corner);
    }
    return corner;
  }

  /// The smaller root stays, so that the result does not depend on the order.
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int corner) { return parents_[static_cast<std::size_t>(corner)]; }

  std::vector<int> parents_;
};

/// Every corner with the vertex of its fan.
struct CornerFans {
  std::vector<int> vertex_of;
  std::vector<int> old_vertex;
  std::size_t cut_edges = 0;
};

/// Join the corners of glued sides. Returns the number of sides that are cut.
template <class Corners>
std::size_t join_fans(std::size_t vertex_count, const Corners& corners, CornerUnion& fans) {
  std::size_t cut_edges = 0;
  const auto tip = [&corners](int side) {
    return static_cast<int>(corners.next(static_cast<std::size_t>(side)));
  };
  SideTable(vertex_count, corners).for_each_edge([&](auto first, auto last) {
    if (last - first == 2 && first->is_rising != first[1].is_rising) {
      fans.join(first->index, tip(first[1].index));
      fans.join(tip(first->index), first[1].index);
    } else if (last - first > 1) {
      cut_edges += static_cast<std::size_t>(last - first);
    }
  });
  return cut_edges;
}

template <class Corners>
CornerFans find_fans(std::size_t vertex_count, const Corners& corners) {
  CornerFans result;
  CornerUnion fans(corners.count());
  result.cut_edges = join_fans(vertex_count, corners, fans);
  result.old_vertex.resize(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) result.old_vertex[v] = static_cast<int>(v);
  std::vector<bool> has_fan(vertex_count, false);
  result.vertex_of.resize(corners.count());
  for (std::size_t corner = 0; corner < corners.count(); ++corner) {
    const int vertex = corners.vertex(corner);
    const auto root = static_cast<std::size_t>(fans.root(static_cast<int>(corner)));
    if (root != corner) {
      result.vertex_of[corner] = result.vertex_of[root];
    } else if (!has_fan[static_cast<std::size_t>(vertex)]) {
      has_fan[static_cast<std::size_t>(vertex)] = true;
      result.vertex_of[corner] = vertex;
    } else {
      result.vertex_of[corner] = static_cast<int>(result.old_vertex.size());
      result.old_vertex.push_back(vertex);
    }
  }
  return result;
}

template <class Mesh, class Corners>
void build_connectivity(Mesh& mesh, std::size_t vertex_count, const Corners& corners) {
  SideTable table(vertex_count, corners);
  HalfedgeAssignment<Mesh, Corners> halfedges(mesh, corners);
  halfedges.assign(table);
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
}

}  // namespace

SeparatedFans separate_fans(std::size_t vertex_count,
                            const std::vector<std::array<int, 3>>& triangles) {
  CornerFans fans = find_fans(vertex_count, TriangleCorners(triangles));
  SeparatedFans result{triangles, std::move(fans.old_vertex), fans.cut_edges};
  for (std::size_t c = 0; c < fans.vertex_of.size(); ++c) {
    result.triangles[c / 3][c % 3] = fans.vertex_of[c];
  }
  return result;
}

SeparatedFaces separate_fans(std::size_t vertex_count, const FaceList& faces) {
  CornerFans fans = find_fans(vertex_count, PolygonCorners(faces));
  SeparatedFaces result{faces, std::move(fans.old_vertex), fans.cut_edges};
  for (std::size_t c = 0; c < fans.vertex_of.size(); ++c) {
    result.faces.set_vertex(c, fans.vertex_of[c]);
  }
  return result;
}

template <class Mesh>
void build_triangles(Mesh& mesh, std::size_t vertex_count,
                     const std::vector<std::array<int, 3>>& triangles) {
  build_connectivity(mesh, vertex_count, TriangleCorners(triangles));
}

template void build_triangles(TriMesh&, std::size_t, const std::vector<std::array<int, 3>>&);
template void build_triangles(PolyMesh&, std::size_t, const std::vector<std::array<int, 3>>&);

void build_faces(PolyMesh& mesh, std::size_t vertex_count, const FaceList& faces) {
  build_connectivity(mesh, vertex_count, PolygonCorners(faces));
}

}  // namespace surfmesh
