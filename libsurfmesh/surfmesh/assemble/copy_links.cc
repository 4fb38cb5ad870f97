// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_links.hh"

#include <algorithm>
#include <cstddef>

#include "surfmesh/assemble/piece_places.hh"

namespace surfmesh::detail {
namespace {

/// Copies the links of a piece as if everything lay inside it, and puts right what does not.
class LinkCopy {
 public:
  LinkCopy(const Piece& piece, const CommonVertices& common, PolyMesh& result)
      : piece_(piece),
        common_(common),
        source_(*piece.source.mesh),
        places_(piece),
        result_(result) {}

  void run() {
    link_inner_vertices();
    link_row();
    link_faces();
    places_.for_each_moved([this](HalfedgeHandle heh) { link_moved(heh); });
    places_.for_each_loose_face([this](const LooseFace& face, std::span<const HalfedgeHandle> at) {
      link_loose(face, at);
    });
  }

 private:
  void link_inner_vertices() {
    const int count = static_cast<int>(source_.n_vertices());
    for (int v = static_cast<int>(piece_.vertices.border_count()); v < count; ++v) {
      const VertexHandle vh(v);
      HalfedgeHandle heh = source_.halfedge_handle(vh);
      if (piece_.is_turned) heh = source_.opposite_halfedge_handle(heh);
      result_.set_halfedge_handle(vertex(vh), places_.in_row(heh));
    }
  }

  void link_row() {
    for (int h = 0; h < places_.row_end(); ++h) {
      const HalfedgeHandle heh(h), to = places_.in_row(heh);
      set_ends(heh, to);
      // A next one that is moved writes this link itself.
      const HalfedgeHandle next = places_.next(heh);
      if (next.idx() < places_.row_end()) {
        result_.set_next_halfedge_handle(to, places_.in_row(next));
      }
    }
  }

  void link_faces() {
    auto dropped = piece_.dropped.begin();
    int number = piece_.first_face;
    for (const FaceHandle fh : source_.faces()) {
      if (dropped != piece_.dropped.end() && *dropped == fh) {
        ++dropped;
      } else {
        result_.set_halfedge_handle(FaceHandle(number++), places_.in_row(first_side(fh)));
      }
    }
  }

  void link_moved(HalfedgeHandle heh) {
    const HalfedgeHandle to = places_(heh), previous = places_.previous(heh);
    set_ends(heh, to);
    join(places_(previous), to, vertex(places_.tip(previous)));
    join(to, places_(places_.next(heh)), vertex(places_.tip(heh)));
    const FaceHandle fh = source_.face_handle(heh);
    result_.set_halfedge_handle(face(fh), places_(first_side(fh)));
  }

  void link_loose(const LooseFace& loose, std::span<const HalfedgeHandle> sides) {
    const FaceHandle fh(piece_.first_face + loose.number);
    for (std::size_t k = 0; k < loose.count; ++k) {
      const std::size_t next = k + 1 == loose.count ? 0 : k + 1;
      const VertexHandle tip(loose.corners[next].vertex);
      result_.set_vertex_handle(sides[k], tip);
      result_.set_face_handle(sides[k], fh);
      join(sides[k], sides[next], tip);
    }
    result_.set_halfedge_handle(fh, sides[0]);
  }

  void set_ends(HalfedgeHandle heh, HalfedgeHandle to) {
    result_.set_vertex_handle(to, vertex(places_.tip(heh)));
    result_.set_face_handle(to, face(source_.face_handle(heh)));
  }

  /// Let a halfedge of the result follow another one, with a vertex between them.
  void join(HalfedgeHandle heh, HalfedgeHandle next, VertexHandle between) {
    result_.set_next_halfedge_handle(heh, next);
    if (common_.is_written_by(piece_.number, between.idx()))
      result_.set_halfedge_handle(between, next);
  }

  /// The side that leads from the first corner of a face to the next one in the result.
  HalfedgeHandle first_side(FaceHandle fh) const {
    const HalfedgeHandle heh = source_.halfedge_handle(fh);
    return piece_.is_turned ? source_.prev_halfedge_handle(heh) : heh;
  }

  VertexHandle vertex(VertexHandle vh) const { return VertexHandle(piece_.vertices(vh)); }

  FaceHandle face(FaceHandle fh) const {
    if (!fh.is_valid()) return fh;
    const auto& dropped = piece_.dropped;
    const auto before = std::lower_bound(dropped.begin(), dropped.end(), fh) - dropped.begin();
    return FaceHandle(piece_.first_face + fh.idx() - static_cast<int>(before));
  }

  const Piece& piece_;
  const CommonVertices& common_;
  const PolyMesh& source_;
  PiecePlaces places_;
  PolyMesh& result_;
};

}  // namespace

void copy_links(const Piece& piece, const CommonVertices& common, PolyMesh& result) {
  LinkCopy(piece, common, result).run();
}

}  // namespace surfmesh::detail
