// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/pieces/partition.hh"
#include "surfmesh/tiles/cut_into_tiles.hh"

namespace surfmesh {

/// How the tiles of a model are dealt to pieces, and these to ranks: alike on all ranks.
struct TileDeal {
  std::vector<int> piece_of;       ///< by tile
  std::vector<int> rank_of_piece;  ///< ascending
  int pieces = 0;

  int rank_of(std::size_t tile) const {
    return rank_of_piece[static_cast<std::size_t>(piece_of[tile])];
  }
};

/// Deal tiles to pieces of about as many triangles each, and runs of pieces to ranks.
///
/// `pieces` is 0 for one for each rank, or for a single rank one for each two million triangles;
/// there are no more pieces than tiles. `deal` is null for runs of tiles that follow each other.
/// Cost     O(n log n) for the nodes on the boundaries of all tiles if `deal` is set
TileDeal deal_out(const std::vector<Tile>& tiles, int pieces, const DealTiles& deal, int ranks);

}  // namespace surfmesh
