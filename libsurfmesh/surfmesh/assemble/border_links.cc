// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/border_links.hh"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "surfmesh/core/parallel.hh"

namespace surfmesh::detail {
namespace {

/// The open halfedge that follows `open`: turn around its tip through the faces there.
HalfedgeHandle next_open_halfedge(const PolyMesh& mesh, HalfedgeHandle open) {
  HalfedgeHandle heh = mesh.opposite_halfedge_handle(open);
  do {
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (!mesh.is_boundary(heh));
  return heh;
}

/// Visit the halfedges that leave a vertex, from one of them on.
template <class Visit>
void for_each_spoke(const PolyMesh& mesh, HalfedgeHandle start, Visit visit) {
  HalfedgeHandle heh = start;
  do {
    visit(heh);
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
}

/// A fan of faces around a vertex, and the first of its corners in the order of the faces.
struct Fan {
  FaceHandle face;
  int corner = 0;  ///< of that face
  HalfedgeHandle spoke;

  friend bool operator<(const Fan& a, const Fan& b) {
    return std::tie(a.face, a.corner) < std::tie(b.face, b.corner);
  }
};

/// The fan to which a halfedge of a face belongs, which leaves its vertex.
Fan fan_at(const PolyMesh& mesh, HalfedgeHandle leaving) {
  Fan fan{mesh.face_handle(leaving), 0, leaving};
  for_each_spoke(mesh, leaving, [&](HalfedgeHandle spoke) {
    const FaceHandle fh = mesh.face_handle(spoke);
    if (!fh.is_valid() || fan.face < fh) return;
    fan.face = fh;
    fan.spoke = spoke;
  });
  for (HalfedgeHandle heh = mesh.halfedge_handle(fan.face); heh != fan.spoke;
       heh = mesh.next_halfedge_handle(heh)) {
    ++fan.corner;
  }
  return fan;
}

/// Let a fan be that of the vertex, whose own halfedge is the open one if there is one.
void give(PolyMesh& mesh, HalfedgeHandle fan, VertexHandle vh) {
  mesh.set_halfedge_handle(vh, fan);
  for_each_spoke(mesh, fan, [&](HalfedgeHandle spoke) {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(spoke), vh);
    if (mesh.is_boundary(spoke)) mesh.set_halfedge_handle(vh, spoke);
  });
}

/// Sides at the border by the vertices that they leave.
class LeavingSides {
 public:
  LeavingSides(const std::vector<BorderSide>& sides, const std::vector<HalfedgeHandle>& halfedges,
               const PolyMesh& mesh)
      : sides_(sides), halfedges_(halfedges), mesh_(mesh), order_(sides.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return std::pair(from(a), a) < std::pair(from(b), b); });
    first_edge_ = mesh.n_edges();
    for (const HalfedgeHandle heh : halfedges_) {
      first_edge_ = std::min(first_edge_, index(mesh.edge_handle(heh)));
    }
  }

  /// The fans at every vertex that has several, those of one vertex in their order.
  std::vector<std::vector<Fan>> several_fans() const {
    std::vector<char> has_several(order_.size(), 0);  // by the first side that leaves a vertex
    share_ranges(order_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (is_first_of_vertex(i) && !is_one_fan(i)) has_several[i] = 1;
      }
    });
    std::vector<std::vector<Fan>> result;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (has_several[i] != 0) result.push_back(fans_of_vertex(i));
    }
    return result;
  }

 private:
  int from(int side) const { return sides_[static_cast<std::size_t>(side)].from; }

  HalfedgeHandle halfedge(std::size_t i) const {
    return halfedges_[static_cast<std::size_t>(order_[i])];
  }

  bool is_first_of_vertex(std::size_t i) const {
    return i == 0 || from(order_[i - 1]) != from(order_[i]);
  }

  std::size_t end_of_vertex(std::size_t i) const {
    do ++i;
    while (i < order_.size() && !is_first_of_vertex(i));
    return i;
  }

  /// True if all sides at the border that leave the vertex do so within one fan.
  bool is_one_fan(std::size_t i) const {
    std::size_t count = 0;
    for_each_spoke(mesh_, halfedge(i), [&](HalfedgeHandle spoke) {
      const bool is_at_border = index(mesh_.edge_handle(spoke)) >= first_edge_;
      if (is_at_border && !mesh_.is_boundary(spoke)) ++count;
    });
    return count == end_of_vertex(i) - i;
  }

  std::vector<Fan> fans_of_vertex(std::size_t i) const {
    std::vector<Fan> fans;
    for (const std::size_t end = end_of_vertex(i); i < end; ++i) {
      fans.push_back(fan_at(mesh_, halfedge(i)));
    }
    std::sort(fans.begin(), fans.end());
    fans.erase(std::unique(fans.begin(), fans.end(),
                           [](const Fan& a, const Fan& b) { return a.spoke == b.spoke; }),
               fans.end());
    return fans;
  }

  const std::vector<BorderSide>& sides_;
  const std::vector<HalfedgeHandle>& halfedges_;
  const PolyMesh& mesh_;
  std::vector<int> order_;
  std::size_t first_edge_;  ///< edges at the border have numbers from here on
};

}  // namespace

void link_open_halfedges(const std::vector<HalfedgeHandle>& sides, PolyMesh& mesh) {
  std::vector<HalfedgeHandle> open;
  for (const HalfedgeHandle side : sides) {
    const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(side);
    if (!mesh.is_boundary(opposite)) continue;
    mesh.set_vertex_handle(opposite, mesh.to_vertex_handle(mesh.prev_halfedge_handle(side)));
    open.push_back(opposite);
  }
  for (const HalfedgeHandle heh : open) {
    mesh.set_next_halfedge_handle(heh, next_open_halfedge(mesh, heh));
    mesh.set_halfedge_handle(mesh.from_vertex_handle(heh), heh);
  }
}

void separate_fans(const std::vector<BorderSide>& sides,
                   const std::vector<HalfedgeHandle>& halfedges, PolyMesh& mesh) {
  const std::vector<std::vector<Fan>> several = LeavingSides(sides, halfedges, mesh).several_fans();
  std::vector<Fan> further;
  for (const std::vector<Fan>& fans : several) {
    further.insert(further.end(), fans.begin() + 1, fans.end());
  }
  std::sort(further.begin(), further.end());
  int count = static_cast<int>(mesh.n_vertices());
  mesh.resize(mesh.n_vertices() + further.size(), mesh.n_edges(), mesh.n_faces());
  for (const Fan& fan : further) {
    const VertexHandle old = mesh.from_vertex_handle(fan.spoke), copy(count++);
    mesh.set_point(copy, mesh.point(old));
    give(mesh, fan.spoke, copy);
  }
  for (const std::vector<Fan>& fans : several) {
    give(mesh, fans.front().spoke, mesh.from_vertex_handle(fans.front().spoke));
  }
}

}  // namespace surfmesh::detail
