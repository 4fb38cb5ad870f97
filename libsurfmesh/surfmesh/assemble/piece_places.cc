// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/piece_places.hh"

#include <algorithm>

namespace surfmesh::detail {

PiecePlaces::PiecePlaces(const Piece& piece)
    : piece_(piece),
      mesh_(*piece.source.mesh),
      first_(2 * piece.first_edge),
      row_end_(2 * piece.copied_edge_count()) {
  auto border = piece.border_edges.begin();
  const auto end = piece.border_edges.end();
  for (; border != end && 2 * border->edge.idx() < row_end_; ++border) add_border_edge(*border);
  std::size_t hole = 0;
  for (int e = row_end_ / 2; e < static_cast<int>(mesh_.n_edges()); ++e) {
    if (border != end && border->edge.idx() == e) {
      add_border_edge(*border++);
    } else {
      const int place = first_ + 2 * moved_[hole++].edge.idx();
      moved_.push_back({EdgeHandle(e), {HalfedgeHandle(place), HalfedgeHandle(place + 1)}});
    }
  }
}

void PiecePlaces::add_border_edge(const BorderEdge& border) {
  MovedEdge& moved = moved_.emplace_back();
  moved.edge = border.edge;
  if (border.side.is_valid()) {
    moved.halfedges[index(border.side) % 2] = piece_.halfedges[copied_side_count_++];
  }
}

HalfedgeHandle PiecePlaces::operator()(HalfedgeHandle heh) const {
  const EdgeHandle edge(heh.idx() / 2);
  const auto moved =
      std::lower_bound(moved_.begin(), moved_.end(), edge,
                       [](const MovedEdge& a, EdgeHandle eh) { return a.edge < eh; });
  if (moved == moved_.end() || moved->edge != edge) return in_row(heh);
  return moved->halfedges[index(heh) % 2];
}

}  // namespace surfmesh::detail
