// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/tile_part.hh"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "surfmesh/assemble/piece_border.hh"

namespace surfmesh {
namespace {

/// Makes the part of a piece whose own vertices are numbered behind the shared ones.
class PartMaker {
 public:
  PartMaker(const detail::Piece& piece, int shared_count)
      : piece_(piece), mesh_(*piece.source.mesh), shared_count_(shared_count) {
    part_.patch = piece.source.boundary.patch;
  }

  TilePart run() {
    collect_shared();
    collect_points();
    part_.faces.reserve(static_cast<std::size_t>(piece_.face_count), corner_count());
    add_faces();
    return std::move(part_);
  }

 private:
  void collect_shared() {
    const auto add = [this](int vertex) {
      if (vertex < shared_count_) part_.shared.push_back(vertex);
    };
    for (const detail::BorderSide& side : piece_.sides) add(side.from);
    for (const VertexHandle vh : border()) add(piece_.vertices(vh));
    std::sort(part_.shared.begin(), part_.shared.end());
    part_.shared.erase(std::unique(part_.shared.begin(), part_.shared.end()), part_.shared.end());
  }

  void collect_points() {
    const int count = piece_.vertices.end_of_own() - shared_count_;
    part_.points.assign(part_.shared.size() + static_cast<std::size_t>(count),
                        Vec3::Constant(kUnset));
    for (const VertexHandle vh : mesh_.vertices()) {
      part_.points[static_cast<std::size_t>(number(piece_.vertices(vh)))] =
          to_eigen(mesh_.point(vh));
    }
  }

  std::size_t corner_count() const {
    return mesh_.n_halfedges() + detail::kMostCorners * piece_.loose_faces.size();
  }

  std::vector<VertexHandle> border() const {
    std::vector<VertexHandle> nodes;
    for (std::size_t v = 0; v < piece_.vertices.border_count(); ++v) {
      nodes.push_back(VertexHandle(static_cast<int>(v)));
    }
    return nodes;
  }

  /// The vertex of the part for one of the piece.
  int number(int vertex) const {
    const auto shared = static_cast<int>(part_.shared.size());
    if (vertex >= shared_count_) return shared + vertex - shared_count_;
    const auto found = std::lower_bound(part_.shared.begin(), part_.shared.end(), vertex);
    return static_cast<int>(found - part_.shared.begin());
  }

  /// Loose faces stand among the copied ones by their numbers, those of fans behind them.
  void add_faces() {
    auto loose = piece_.loose_faces.begin();
    auto collapsed = piece_.collapsed.begin();
    for (const FaceHandle fh : mesh_.faces()) {
      if (collapsed == piece_.collapsed.end() || collapsed->face != fh) {
        add(fh);
      } else if (!(collapsed++)->is_dropped) {
        add(*loose++);
      }
    }
    for (; loose != piece_.loose_faces.end(); ++loose) add(*loose);
  }

  void add(FaceHandle fh) {
    std::array<int, detail::kMostCorners> corners{};
    std::size_t count = 0;
    const HalfedgeHandle start = mesh_.halfedge_handle(fh);
    HalfedgeHandle heh = start;
    do {
      corners[count++] = number(piece_.vertices(mesh_.to_vertex_handle(heh)));
      heh = mesh_.next_halfedge_handle(heh);
    } while (heh != start && count < corners.size());
    // A face that is turned begins at the origin of the side before, and goes round backwards.
    if (piece_.is_turned) {
      std::reverse(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count));
      std::rotate(corners.begin(), corners.begin() + 1,
                  corners.begin() + static_cast<std::ptrdiff_t>(count));
    }
    part_.faces.add(std::span(corners).first(count));
  }

  void add(const detail::LooseFace& face) {
    std::array<int, detail::kMostCorners> corners{};
    for (std::size_t k = 0; k < face.count; ++k) {
      corners[k] = number(face.corners[k + 1 == face.count ? 0 : k + 1].vertex);
    }
    part_.faces.add(std::span(corners).first(face.count));
  }

  const detail::Piece& piece_;
  const PolyMesh& mesh_;
  int shared_count_;
  TilePart part_;
};

}  // namespace

detail::Piece surveyed(PatchMesh tile, const NodeNumbers& numbers, bool is_turned) {
  const detail::PieceVertices vertices(tile.boundary, tile.mesh->n_vertices(), numbers.count());
  detail::Piece piece{0, std::move(tile), is_turned, vertices};
  detail::survey_border(piece);
  return piece;
}

TilePart part_of(const detail::Piece& tile, int shared_count) {
  return PartMaker(tile, shared_count).run();
}

}  // namespace surfmesh
