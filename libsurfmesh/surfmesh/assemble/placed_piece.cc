// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/placed_piece.hh"

namespace surfmesh::detail {
namespace {

constexpr int kUnplaced = -1;

}  // namespace

void place_edges(Piece& piece) {
  std::vector<int>& places = piece.edge_places;
  places.assign(piece.source.mesh->n_edges(), kUnplaced);
  // Both halfedges of an edge are found by the place of its first one.
  const auto put = [&](HalfedgeHandle heh, int place) {
    places[index(heh) / 2] = place ^ (heh.idx() & 1);
  };
  std::size_t side = 0;
  for (const BorderEdge& border : piece.border_edges) {
    if (border.side.is_valid()) put(border.side, piece.halfedges[side++].idx());
  }
  const PlacedPiece placed(piece);
  int next = 2 * piece.first_edge;
  for (const FaceHandle fh : piece.source.mesh->faces()) {
    if (!placed.is_copied(fh)) continue;
    placed.for_each_side(fh, [&](HalfedgeHandle heh) {
      if (places[index(heh) / 2] != kUnplaced) return;
      put(heh, next);
      next += 2;
    });
  }
}

}  // namespace surfmesh::detail
