// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "surfmesh/across/region_work.hh"

namespace surfmesh {

/// Elements of one kind that a region gives up in the result, and those of its own that have no
/// number there yet.
struct ElementExchange {
  std::vector<int> given_up;  ///< numbers in the result
  std::vector<int> wanting;   ///< numbers in the region
};

/// A region on its way back into the result that it was taken from, with the numbers that its
/// elements get there. What it has kept keeps its number; new elements get those that the region
/// gives up, so that they lie among their neighbours.
class ReturningRegion {
 public:
  /// Cost     O(elements of the region)
  ReturningRegion(const RegionWork& work, const PolyMesh& result);

  const PolyMesh& mesh() const { return mesh_; }

  /// What is left over when the region has used its own numbers, to be had from other regions.
  const ElementExchange& vertices() const { return vertices_; }
  const ElementExchange& edges() const { return edges_; }
  void set_number(VertexHandle vh, int number) { vertex_numbers_[index(vh)] = number; }
  void set_number(EdgeHandle eh, int number) { sides_[index(eh)] = HalfedgeHandle(2 * number); }

  /// How many faces the region has, by patch.
  const std::map<int, std::size_t>& face_counts() const { return face_counts_; }

  /// Vertices at the border that must leave by another halfedge of the result, and which.
  const std::vector<std::pair<VertexHandle, HalfedgeHandle>>& relinked() const { return relinked_; }

  VertexHandle in_result(VertexHandle vh) const { return VertexHandle(vertex_numbers_[index(vh)]); }

  HalfedgeHandle in_result(HalfedgeHandle heh) const {
    const HalfedgeHandle first = sides_[index(mesh_.edge_handle(heh))];
    return heh.idx() % 2 == 0 ? first : mesh_.opposite_halfedge_handle(first);
  }

  const FaceInPatch& in_patch(FaceHandle fh) const { return work_.faces[index(fh)]; }

  /// Call `visit` with each face that is left.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (std::size_t f = 0; f < work_.editor->face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (work_.editor->is_used(fh)) visit(fh);
    }
  }

  /// Call `visit(vertex, chart)` with each vertex inside the region that is left; the chart is null
  /// if it is where it was.
  template <class Visit>
  void for_each_inner_vertex(Visit visit) const {
    for (std::size_t v = 0; v < work_.editor->vertex_bound(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      if (!work_.editor->is_used(vh) || mesh_.is_boundary(vh)) continue;
      visit(vh, work_.is_moved(vh) ? &work_.charts[v] : nullptr);
    }
  }

 private:
  void survey_vertices();
  void survey_edges();
  void survey_border(const PolyMesh& result);

  const RegionWork& work_;
  const PolyMesh& mesh_;
  std::vector<int> vertex_numbers_;    ///< in the result, by vertex
  std::vector<HalfedgeHandle> sides_;  ///< in the result, by edge: its first halfedge
  ElementExchange vertices_, edges_;
  std::map<int, std::size_t> face_counts_;
  std::vector<std::pair<VertexHandle, HalfedgeHandle>> relinked_;
};

}  // namespace surfmesh
