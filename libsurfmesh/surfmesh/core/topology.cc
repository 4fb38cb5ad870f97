// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/topology.hh"

#include <algorithm>
#include <cstdint>

namespace surfmesh {
namespace {

/// One side of a triangle, filed under the smaller of its vertices.
struct Side {
  int larger;     ///< the larger of its two vertices
  int index;      ///< 3 × triangle + corner at its origin
  bool is_rising; ///< leads from the smaller to the larger vertex
};

/// Sides of all triangles sorted by their smaller, then by their larger vertex.
class SideTable {
 public:
  SideTable(std::size_t vertex_count, const std::vector<std::array<int, 3>>& triangles)
      : first_(vertex_count + 1, 0), sides_(3 * triangles.size()) {
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) ++first_[smaller(t, k) + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangles[f][k], b = triangles[f][(k + 1) % 3];
        sides_[next[smaller(triangles[f], k)]++] = {std::max(a, b), static_cast<int>(3 * f + k),
                                                    a < b};
      }
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
  static std::size_t smaller(const std::array<int, 3>& t, std::size_t k) {
    return static_cast<std::size_t>(std::min(t[k], t[(k + 1) % 3]));
  }

  std::vector<Side>::iterator begin(std::size_t v) {
    return sides_.begin() + static_cast<std::ptrdiff_t>(first_[v]);
  }

  std::vector<std::size_t> first_;
  std::vector<Side> sides_;
};

/// Give every side of every triangle its halfedge; glued sides get the two of one edge.
template <class Mesh>
class HalfedgeAssignment {
 public:
  HalfedgeAssignment(Mesh& mesh, const std::vector<std::array<int, 3>>& triangles)
      : mesh_(mesh), triangles_(triangles), halfedge_of_(3 * triangles.size()) {}

  HalfedgeHandle of(int side) const { return halfedge_of_[static_cast<std::size_t>(side)]; }

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
      const auto& t = triangles_[side / 3];
      const HalfedgeHandle heh = halfedge_of_[side];
      mesh_.set_vertex_handle(heh, VertexHandle(t[(side + 1) % 3]));
      mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(heh), VertexHandle(t[side % 3]));
    }
  }

 private:
  void give(int side, std::size_t halfedge) {
    halfedge_of_[static_cast<std::size_t>(side)] = HalfedgeHandle(static_cast<int>(halfedge));
  }

  Mesh& mesh_;
  const std::vector<std::array<int, 3>>& triangles_;
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

/// Corners of triangles (3 × triangle + corner), joined where they belong to one fan.
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

/// The corner at the tip of a side.
int tip(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

}  // namespace

SeparatedFans separate_fans(std::size_t vertex_count,
                            const std::vector<std::array<int, 3>>& triangles) {
  SeparatedFans result;
  SideTable table(vertex_count, triangles);
  CornerUnion corners(3 * triangles.size());
  table.for_each_edge([&](auto first, auto last) {
    if (last - first == 2 && first->is_rising != first[1].is_rising) {
      corners.join(first->index, tip(first[1].index));
      corners.join(tip(first->index), first[1].index);
    } else if (last - first > 1) {
      result.cut_edges += static_cast<std::size_t>(last - first);
    }
  });
  result.old_vertex.resize(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) result.old_vertex[v] = static_cast<int>(v);
  std::vector<int> first_fan(vertex_count, -1);
  std::vector<int> vertex_of(3 * triangles.size());
  result.triangles = triangles;
  for (std::size_t corner = 0; corner < vertex_of.size(); ++corner) {
    int& vertex = result.triangles[corner / 3][corner % 3];
    const auto root = static_cast<std::size_t>(corners.root(static_cast<int>(corner)));
    if (root == corner) {
      int& fan = first_fan[static_cast<std::size_t>(vertex)];
      if (fan < 0) {
        fan = vertex_of[corner] = vertex;
      } else {
        vertex_of[corner] = static_cast<int>(result.old_vertex.size());
        result.old_vertex.push_back(vertex);
      }
    }
    vertex = vertex_of[root];
  }
  return result;
}

template <class Mesh>
void build_triangles(Mesh& mesh, std::size_t vertex_count,
                     const std::vector<std::array<int, 3>>& triangles) {
  SideTable table(vertex_count, triangles);
  HalfedgeAssignment<Mesh> halfedges(mesh, triangles);
  halfedges.assign(table);
  mesh.resize(vertex_count, halfedges.edge_count(), triangles.size());
  halfedges.set_vertices();
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    for (int k = 0; k < 3; ++k) {
      const HalfedgeHandle heh = halfedges.of(static_cast<int>(3 * f) + k);
      mesh.set_next_halfedge_handle(heh, halfedges.of(static_cast<int>(3 * f) + (k + 1) % 3));
      mesh.set_face_handle(heh, fh);
      mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
    }
    mesh.set_halfedge_handle(fh, halfedges.of(static_cast<int>(3 * f)));
  }
  link_open_halfedges(mesh);
}

template void build_triangles(TriMesh&, std::size_t, const std::vector<std::array<int, 3>>&);
template void build_triangles(PolyMesh&, std::size_t, const std::vector<std::array<int, 3>>&);

}  // namespace surfmesh
