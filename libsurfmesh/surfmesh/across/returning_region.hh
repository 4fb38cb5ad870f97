// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <span>
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

/// A corner of a face on its way back.
struct ReturningCorner {
  HalfedgeHandle side;  ///< of the region, that leaves it
  VertexHandle vertex;  ///< of the region
  Uv uv;
  Metric metric;
  bool is_beyond = false;
  bool is_inner = false;  ///< the vertex is not at the border of the region
};

/// A vertex on its way back that has moved, or is new.
struct MovedVertex {
  VertexHandle vertex;  ///< of the region
  Vec3 point;
  SurfacePlace place;
};

/// A region on its way back into the result that it was taken from, with the numbers that its
/// elements get there. What it has kept keeps its number; new elements get those that the region
/// gives up, so that they lie among their neighbours.
///
/// Of the work nothing stays but what is to be written, half of its memory: all regions are there
/// before the first one is put back.
class ReturningRegion {
 public:
  /// Cost     O(elements of the region)
  ReturningRegion(const RegionWork& work, const PolyMesh& result);

  /// The faces of the result that the region was made of.
  const FacePiece& taken() const { return taken_; }

  /// What is left over when the region has used its own numbers, to be had from other regions.
  const ElementExchange& vertices() const { return vertices_; }
  const ElementExchange& edges() const { return edges_; }
  void set_number(VertexHandle vh, int number) { vertex_numbers_[index(vh)] = number; }
  void set_number(EdgeHandle eh, int number) { sides_[index(eh)] = HalfedgeHandle(2 * number); }

  VertexHandle in_result(VertexHandle vh) const { return VertexHandle(vertex_numbers_[index(vh)]); }

  HalfedgeHandle in_result(HalfedgeHandle heh) const {
    // The two halfedges of an edge have numbers that differ in the last bit.
    return HalfedgeHandle(sides_[index(heh) / 2].idx() ^ (heh.idx() & 1));
  }

  /// True for a side of a new edge, which takes the number of any other one.
  bool is_new(HalfedgeHandle heh) const { return index(heh) / 2 >= kept_edges_; }

  /// How many faces the region has, by patch.
  const std::map<int, std::size_t>& face_counts() const { return face_counts_; }

  /// Call `visit(patch, corners)` with each face.
  template <class Visit>
  void for_each_face(Visit visit) const {
    std::size_t first = 0;
    for (const auto& [patch, end] : faces_) {
      visit(patch, std::span(corners_).subspan(first, end - first));
      first = end;
    }
  }

  const std::vector<MovedVertex>& moved() const { return moved_; }

  /// Vertices at the border that must leave by another halfedge, both of the result.
  const std::vector<std::pair<VertexHandle, HalfedgeHandle>>& relinked() const { return relinked_; }

 private:
  void collect_faces(const RegionWork& work);
  void collect_vertices(const RegionWork& work);
  void collect_edges();
  void collect_border(const PolyMesh& mesh, const PolyMesh& result);

  FacePiece taken_;
  std::vector<int> vertex_numbers_;    ///< in the result, by vertex
  std::vector<HalfedgeHandle> sides_;  ///< in the result, by edge: its first halfedge
  std::size_t kept_edges_;             ///< edges below this were in the region from the start
  ElementExchange vertices_, edges_;
  std::vector<std::pair<int, std::size_t>> faces_;  ///< patch and end of the corners of each
  std::vector<ReturningCorner> corners_;
  std::map<int, std::size_t> face_counts_;
  std::vector<MovedVertex> moved_;
  std::vector<std::pair<VertexHandle, HalfedgeHandle>> relinked_;
};

}  // namespace surfmesh
