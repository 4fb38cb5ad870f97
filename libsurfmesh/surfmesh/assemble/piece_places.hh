// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Where the halfedges of a piece are in the result.
///
/// The copied edges have numbers in a row: each keeps its place in it, and those behind the end
/// fill the places of edges at the border, whose sides have been given halfedges elsewhere.
class PiecePlaces {
 public:
  explicit PiecePlaces(const Piece& piece);

  /// Halfedges below this number keep their places, but for those of edges at the border.
  int row_end() const { return row_end_; }

  /// The halfedge of the result at the place of one that keeps it.
  HalfedgeHandle in_row(HalfedgeHandle heh) const { return HalfedgeHandle(first_ + heh.idx()); }

  /// The halfedge of the result for any one of a face that is copied.
  HalfedgeHandle operator()(HalfedgeHandle heh) const;

  /// Visit the halfedges of copied faces that do not keep their places.
  template <class Visit>
  void for_each_moved(Visit visit) const {
    for (const MovedEdge& moved : moved_) {
      for (const unsigned k : {0u, 1u}) {
        if (moved.halfedges[k].is_valid()) visit(mesh_.halfedge_handle(moved.edge, k));
      }
    }
  }

  /// Call `visit` for each loose face with the halfedges of its sides.
  template <class Visit>
  void for_each_loose_face(Visit visit) const {
    std::size_t side = copied_side_count_;
    for (const LooseFace& face : piece_.loose_faces) {
      visit(face, piece_.halfedges.subspan(side, face.count));
      side += face.count;
    }
  }

  /// The tip that a halfedge has in the result, where a turned piece has it at the other end.
  VertexHandle tip(HalfedgeHandle heh) const {
    return piece_.is_turned ? mesh_.from_vertex_handle(heh) : mesh_.to_vertex_handle(heh);
  }

  /// The halfedge that follows in the result.
  HalfedgeHandle next(HalfedgeHandle heh) const {
    return piece_.is_turned ? mesh_.prev_halfedge_handle(heh) : mesh_.next_halfedge_handle(heh);
  }

  HalfedgeHandle previous(HalfedgeHandle heh) const {
    return piece_.is_turned ? mesh_.next_halfedge_handle(heh) : mesh_.prev_halfedge_handle(heh);
  }

 private:
  /// An edge that does not keep its place, and its halfedges in the result; they are invalid if
  /// they are not copied.
  struct MovedEdge {
    EdgeHandle edge;
    std::array<HalfedgeHandle, 2> halfedges = {HalfedgeHandle(), HalfedgeHandle()};
  };

  void add_border_edge(const BorderEdge& border);

  const Piece& piece_;
  const PolyMesh& mesh_;
  int first_;
  int row_end_;
  std::size_t copied_side_count_ = 0;  ///< sides of faces that are copied
  std::vector<MovedEdge> moved_;       ///< ascending
};

}  // namespace surfmesh::detail
