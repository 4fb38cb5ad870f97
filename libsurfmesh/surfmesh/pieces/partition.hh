// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Two tiles that have nodes in common.
struct TileNeighbours {
  int first = 0, second = 0;  ///< ascending
  int nodes = 0;              ///< that they have in common
};

/// The tiles of a model as a graph.
struct TileGraph {
  std::vector<double> weights;             ///< triangles by tile
  std::vector<TileNeighbours> neighbours;  ///< ascending
};

/// Deals tiles to a number of pieces of about equal weight. Returns the piece of each tile.
using DealTiles = std::function<std::vector<int>(const TileGraph& graph, int pieces)>;

/// Deal runs of tiles that follow each other: patches stay together, and the numbers of a piece
/// follow each other, too. The heaviest piece is as light as runs allow, and the others are about
/// even. Pieces stay empty only if there are fewer tiles: the last ones then.
///
/// Returns  the piece of each tile, ascending
/// Cost     O(tiles), some 50 times
std::vector<int> deal_in_runs(const std::vector<double>& weights, int pieces);

}  // namespace surfmesh
