// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_piece.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

/// Where an edge of the piece's mesh has gone that is not at its place in the row of copied ones.
struct MovedEdge {
  EdgeHandle edge;
  /// For both halfedges those of the result; invalid if they are not copied.
  std::array<HalfedgeHandle, 2> halfedges;
};

/// The copied edges have numbers in a row: each keeps its place in it, and those behind the end
/// fill the places of edges at the border, whose sides have been given halfedges elsewhere.
class HalfedgePlaces {
 public:
  HalfedgePlaces(const Piece& piece, std::span<const HalfedgeHandle> halfedges)
      : first_(2 * piece.first_edge), copied_(piece.copied_edge_count()) {
    const int edge_count = static_cast<int>(piece.source.mesh->n_edges());
    auto border = piece.border_edges.begin();
    std::size_t side = 0;
    const auto add_border_edge = [&] {
      moved_.emplace_back().edge = border->edge;
      if (border->side.is_valid()) {
        moved_.back().halfedges[index(border->side) % 2] = halfedges[side++];
      }
      ++border;
    };
    while (border != piece.border_edges.end() && border->edge.idx() < copied_) add_border_edge();
    for (int e = copied_, hole = 0; e < edge_count; ++e) {
      if (border != piece.border_edges.end() && border->edge.idx() == e) {
        add_border_edge();
      } else {
        const int place = first_ + 2 * moved_[static_cast<std::size_t>(hole++)].edge.idx();
        moved_.push_back({EdgeHandle(e), {HalfedgeHandle(place), HalfedgeHandle(place + 1)}});
      }
    }
  }

  /// Number of edges that keep their places, or would if they were copied.
  int copied() const { return copied_; }

  const std::vector<MovedEdge>& moved() const { return moved_; }

  /// The halfedge of the result at the place of one whose edge is not moved.
  HalfedgeHandle in_place(HalfedgeHandle heh) const { return HalfedgeHandle(first_ + heh.idx()); }

  /// The halfedge of the result for one of a face that is copied.
  HalfedgeHandle operator()(HalfedgeHandle heh) const {
    const EdgeHandle edge(heh.idx() / 2);
    const auto moved =
        std::lower_bound(moved_.begin(), moved_.end(), edge,
                         [](const MovedEdge& a, EdgeHandle eh) { return a.edge < eh; });
    if (moved == moved_.end() || moved->edge != edge) return in_place(heh);
    return moved->halfedges[index(heh) % 2];
  }

 private:
  int first_;
  int copied_;
  std::vector<MovedEdge> moved_;  ///< ascending
};

/// Copies a piece as if everything lay inside it, and puts right what does not.
class PieceCopy {
 public:
  PieceCopy(const Piece& piece, int number, const CommonVertices& common,
            std::span<const HalfedgeHandle> halfedges, ResultArrays& result)
      : piece_(piece),
        number_(number),
        common_(common),
        halfedges_(halfedges),
        places_(piece, halfedges),
        source_(*piece.source.mesh),
        uv_(source_.property(require(source_, keys::vertex_uv)).data_vector()),
        metric_(source_.property(require(source_, keys::vertex_metric)).data_vector()),
        result_(result),
        mesh_(result.mesh) {}

  void run() {
    copy_vertices();
    copy_edges();
    copy_faces();
    for (const MovedEdge& moved : places_.moved()) {
      for (const unsigned k : {0u, 1u}) {
        if (moved.halfedges[k].is_valid()) link(source_.halfedge_handle(moved.edge, k));
      }
    }
    add_loose_faces();
  }

 private:
  void copy_vertices() {
    const int border = static_cast<int>(piece_.vertices.border_count());
    for (int v = 0; v < border; ++v) {
      const int vertex = piece_.vertices(VertexHandle(v));
      if (common_.is_on_contour(vertex) || !common_.is_written_by(number_, vertex)) continue;
      mesh_.set_point(VertexHandle(vertex), source_.point(VertexHandle(v)));
    }
    for (int v = border; v < static_cast<int>(source_.n_vertices()); ++v) {
      const VertexHandle from(v), to(piece_.vertices(from));
      const HalfedgeHandle heh = source_.halfedge_handle(from);
      mesh_.set_point(to, source_.point(from));
      mesh_.set_halfedge_handle(
          to, places_.in_place(piece_.is_turned ? source_.opposite_halfedge_handle(heh) : heh));
    }
  }

  void copy_edges() {
    const int count = 2 * places_.copied();
    for (int h = 0; h < count; ++h) {
      const HalfedgeHandle heh(h), to = places_.in_place(heh);
      set_corner(heh, to);
      const HalfedgeHandle next =
          piece_.is_turned ? source_.prev_halfedge_handle(heh) : source_.next_halfedge_handle(heh);
      // The next one writes this link itself where its edge is moved.
      if (next.idx() < count) mesh_.set_next_halfedge_handle(to, places_.in_place(next));
    }
  }

  void copy_faces() {
    auto dropped = piece_.dropped.begin();
    int face = piece_.first_face;
    for (const FaceHandle fh : source_.faces()) {
      if (dropped != piece_.dropped.end() && *dropped == fh) {
        ++dropped;
        continue;
      }
      mesh_.set_halfedge_handle(FaceHandle(face), places_.in_place(first_side(fh)));
      result_.patch[static_cast<std::size_t>(face++)] = piece_.source.boundary.patch;
    }
  }

  /// The side of a face from its first corner to the next one in the result.
  HalfedgeHandle first_side(FaceHandle fh) const {
    const HalfedgeHandle heh = source_.halfedge_handle(fh);
    return piece_.is_turned ? source_.prev_halfedge_handle(heh) : heh;
  }

  /// The tip of a halfedge in the result.
  VertexHandle tip(HalfedgeHandle heh) const {
    return piece_.is_turned ? source_.from_vertex_handle(heh) : source_.to_vertex_handle(heh);
  }

  FaceHandle face(FaceHandle fh) const {
    if (!fh.is_valid()) return fh;
    const auto& dropped = piece_.dropped;
    const auto before = std::lower_bound(dropped.begin(), dropped.end(), fh) - dropped.begin();
    return FaceHandle(piece_.first_face + fh.idx() - static_cast<int>(before));
  }

  /// Set the face and the tip of a halfedge, and what the result holds of that corner.
  void set_corner(HalfedgeHandle heh, HalfedgeHandle to) {
    const VertexHandle vh = tip(heh);
    mesh_.set_vertex_handle(to, VertexHandle(piece_.vertices(vh)));
    mesh_.set_face_handle(to, face(source_.face_handle(heh)));
    result_.uv[index(to)] = uv_[index(vh)];
    result_.metric[index(to)] = metric_[index(vh)];
  }

  /// Write a halfedge of a face that is copied whose edge is moved, and the links to it.
  void link(HalfedgeHandle heh) {
    set_corner(heh, places_(heh));
    HalfedgeHandle before = source_.prev_halfedge_handle(heh);
    HalfedgeHandle after = source_.next_halfedge_handle(heh);
    if (piece_.is_turned) std::swap(before, after);
    join(places_(before), places_(heh), VertexHandle(piece_.vertices(tip(before))));
    join(places_(heh), places_(after), VertexHandle(piece_.vertices(tip(heh))));
    const FaceHandle fh = source_.face_handle(heh);
    mesh_.set_halfedge_handle(face(fh), places_(first_side(fh)));
  }

  /// Let a halfedge follow another one, with a vertex between them.
  void join(HalfedgeHandle heh, HalfedgeHandle next, VertexHandle between) {
    mesh_.set_next_halfedge_handle(heh, next);
    if (common_.is_written_by(number_, between.idx())) mesh_.set_halfedge_handle(between, next);
  }

  void add_loose_faces() {
    std::size_t corner_count = 0;
    for (const LooseFace& loose : piece_.loose_faces) corner_count += loose.count;
    std::size_t side = piece_.sides.size() - corner_count;
    for (const LooseFace& loose : piece_.loose_faces) {
      add(loose, halfedges_.subspan(side, loose.count));
      side += loose.count;
    }
  }

  void add(const LooseFace& loose, std::span<const HalfedgeHandle> sides) {
    const FaceHandle fh(piece_.first_face + loose.number);
    for (std::size_t k = 0; k < loose.count; ++k) {
      const std::size_t next = k + 1 == loose.count ? 0 : k + 1;
      const LooseCorner& corner = loose.corners[next];
      mesh_.set_vertex_handle(sides[k], VertexHandle(corner.vertex));
      mesh_.set_face_handle(sides[k], fh);
      result_.uv[index(sides[k])] = corner.value.uv;
      result_.metric[index(sides[k])] = corner.value.metric;
      join(sides[k], sides[next], VertexHandle(corner.vertex));
    }
    mesh_.set_halfedge_handle(fh, sides[0]);
    result_.patch[index(fh)] = piece_.source.boundary.patch;
  }

  const Piece& piece_;
  int number_;
  const CommonVertices& common_;
  std::span<const HalfedgeHandle> halfedges_;  ///< by side of the piece
  HalfedgePlaces places_;
  const PolyMesh& source_;
  const std::vector<Uv>& uv_;          ///< by vertex of the source
  const std::vector<Metric>& metric_;  ///< likewise
  ResultArrays& result_;
  PolyMesh& mesh_;  ///< of the result
};

}  // namespace

void copy_piece(const Piece& piece, int number, const CommonVertices& common,
                std::span<const HalfedgeHandle> halfedges, ResultArrays& result) {
  PieceCopy(piece, number, common, halfedges, result).run();
}

}  // namespace surfmesh::detail
