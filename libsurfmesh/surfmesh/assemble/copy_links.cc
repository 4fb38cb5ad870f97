// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_links.hh"

#include <cstddef>
#include <span>

#include "surfmesh/assemble/placed_piece.hh"

namespace surfmesh::detail {
namespace {

class LinkCopy {
 public:
  LinkCopy(const Piece& piece, const CommonVertices& common, PolyMesh& result)
      : piece_(piece), common_(common), placed_(piece), result_(result) {}

  void link_copied_faces() {
    const PolyMesh& source = *piece_.source.mesh;
    placed_.for_each_side([&](HalfedgeHandle heh) {
      link(placed_.place(heh), placed_.place(placed_.next(heh)), piece_.vertices(placed_.tip(heh)),
           placed_.number(source.face_handle(heh)));
    });
    for (const FaceHandle fh : source.faces()) {
      if (!placed_.is_copied(fh)) continue;
      result_.set_halfedge_handle(placed_.number(fh), placed_.place(placed_.first_side(fh)));
    }
  }

  void link_loose_faces() {
    placed_.for_each_loose_face(
        [this](const LooseFace& face, std::span<const HalfedgeHandle> sides) {
          const FaceHandle number(piece_.first_face + face.number);
          for (std::size_t k = 0; k < face.count; ++k) {
            const std::size_t next = k + 1 == face.count ? 0 : k + 1;
            link(sides[k], sides[next], face.corners[next].vertex, number);
          }
          result_.set_halfedge_handle(number, sides[0]);
        });
  }

 private:
  /// Let a side of a face be followed by another one, with a vertex between them.
  void link(HalfedgeHandle side, HalfedgeHandle next, int between, FaceHandle fh) {
    const VertexHandle vh(between);
    result_.set_vertex_handle(side, vh);
    result_.set_face_handle(side, fh);
    result_.set_next_halfedge_handle(side, next);
    if (common_.is_written_by(piece_.number, between)) result_.set_halfedge_handle(vh, next);
  }

  const Piece& piece_;
  const CommonVertices& common_;
  PlacedPiece placed_;
  PolyMesh& result_;
};

}  // namespace

void copy_links(const Piece& piece, const CommonVertices& common, PolyMesh& result) {
  LinkCopy copy(piece, common, result);
  copy.link_copied_faces();
  copy.link_loose_faces();
}

}  // namespace surfmesh::detail
