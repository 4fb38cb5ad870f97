// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "surfmesh/assemble/piece.hh"

namespace surfmesh::detail {

/// Give the edges of a piece their places in the result: those inside in the order of the faces,
/// those at the border where its sides have been given halfedges.
///
/// Writes   edge_places of the piece
/// Cost     O(n)
void place_edges(Piece& piece);

/// A piece whose edges have places, as the result sees it: of a turned piece, faces go around the
/// other way from the same corner on, and the tip of a halfedge is at its other end.
class PlacedPiece {
 public:
  explicit PlacedPiece(const Piece& piece) : piece_(piece), mesh_(*piece.source.mesh) {}

  /// The halfedge of the result for one of a face that is copied.
  HalfedgeHandle place(HalfedgeHandle heh) const {
    return HalfedgeHandle(piece_.edge_places[index(heh) / 2] ^ (heh.idx() & 1));
  }

  /// The tip that a halfedge has in the result, a vertex of the piece's mesh.
  VertexHandle tip(HalfedgeHandle heh) const {
    return piece_.is_turned ? mesh_.from_vertex_handle(heh) : mesh_.to_vertex_handle(heh);
  }

  /// The halfedge that follows in the result.
  HalfedgeHandle next(HalfedgeHandle heh) const {
    return piece_.is_turned ? mesh_.prev_halfedge_handle(heh) : mesh_.next_halfedge_handle(heh);
  }

  /// The side that leads from the first corner of a face to the next one in the result.
  HalfedgeHandle first_side(FaceHandle fh) const {
    const HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    return piece_.is_turned ? mesh_.prev_halfedge_handle(heh) : heh;
  }

  /// The number that a face has in the result, if it is copied.
  FaceHandle number(FaceHandle fh) const {
    const auto next = first_collapsed_from(fh);
    const int dropped = next == piece_.collapsed.begin() ? 0 : std::prev(next)->dropped_so_far;
    return FaceHandle(piece_.first_face + fh.idx() - dropped);
  }

  bool is_copied(FaceHandle fh) const {
    if (!fh.is_valid()) return false;
    const auto next = first_collapsed_from(fh);
    return next == piece_.collapsed.end() || next->face != fh;
  }

  /// Call `visit(side)` for the sides of a face in the order that they have in the result.
  template <class Visit>
  void for_each_side(FaceHandle fh, Visit visit) const {
    const HalfedgeHandle first = first_side(fh);
    HalfedgeHandle heh = first;
    do {
      visit(heh);
      heh = next(heh);
    } while (heh != first);
  }

  /// Call `visit(side)` for the sides of all faces that are copied, in the order of their memory.
  template <class Visit>
  void for_each_side(Visit visit) const {
    for (const HalfedgeHandle heh : mesh_.halfedges()) {
      if (is_copied(mesh_.face_handle(heh))) visit(heh);
    }
  }

  /// Call `visit(face, halfedges)` for each loose face with the halfedges of its sides.
  template <class Visit>
  void for_each_loose_face(Visit visit) const {
    std::size_t corners = 0;
    for (const LooseFace& face : piece_.loose_faces) corners += face.count;
    std::span<const HalfedgeHandle> rest = piece_.halfedges.last(corners);
    for (const LooseFace& face : piece_.loose_faces) {
      visit(face, rest.first(face.count));
      rest = rest.subspan(face.count);
    }
  }

 private:
  std::vector<CollapsedFace>::const_iterator first_collapsed_from(FaceHandle fh) const {
    const auto is_before = [](const CollapsedFace& collapsed, FaceHandle face) {
      return collapsed.face < face;
    };
    return std::lower_bound(piece_.collapsed.begin(), piece_.collapsed.end(), fh, is_before);
  }

  const Piece& piece_;
  const PolyMesh& mesh_;
};

}  // namespace surfmesh::detail
