// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_metis/deal_by_metis.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace surfmesh {
namespace {

/// Tiles of a square grid, row by row, that share `along` nodes in a row and `across` between rows.
TileGraph grid_of_tiles(int size, int along, int across) {
  TileGraph graph;
  graph.weights.assign(static_cast<std::size_t>(size * size), 1e5);
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      const int tile = j * size + i;
      if (i + 1 < size) graph.neighbours.push_back({tile, tile + 1, along});
      if (j + 1 < size) graph.neighbours.push_back({tile, tile + size, across});
    }
  }
  return graph;
}

/// Nodes in common of tiles in different pieces.
int cut_of(const TileGraph& graph, const std::vector<int>& piece_of) {
  int cut = 0;
  for (const TileNeighbours& pair : graph.neighbours) {
    const auto piece = [&](int tile) { return piece_of[static_cast<std::size_t>(tile)]; };
    if (piece(pair.first) != piece(pair.second)) cut += pair.nodes;
  }
  return cut;
}

std::vector<int> sizes_of(const std::vector<int>& piece_of, int pieces) {
  std::vector<int> sizes(static_cast<std::size_t>(pieces));
  for (const int piece : piece_of) ++sizes[static_cast<std::size_t>(piece)];
  return sizes;
}

TEST(DealByMetis, CutsLessThanRuns) {
  const TileGraph graph = grid_of_tiles(16, 10, 10);
  const std::vector<int> by_metis = deal_by_metis(graph, 16);
  EXPECT_LT(cut_of(graph, by_metis), 0.6 * cut_of(graph, deal_in_runs(graph.weights, 16)));
  const std::vector<int> sizes = sizes_of(by_metis, 16);
  EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()), 18);
}

TEST(DealByMetis, CutsWhereFewVerticesAreShared) {
  const TileGraph graph = grid_of_tiles(8, 1, 100);
  const std::vector<int> piece_of = deal_by_metis(graph, 2);
  EXPECT_EQ(cut_of(graph, piece_of), 8);
}

TEST(DealByMetis, GivesTheSamePiecesAgainNumberedByTheirFirstTiles) {
  const TileGraph graph = grid_of_tiles(12, 3, 5);
  const std::vector<int> piece_of = deal_by_metis(graph, 7);
  EXPECT_EQ(deal_by_metis(graph, 7), piece_of);
  int seen = 0;
  for (const int piece : piece_of) {
    EXPECT_LE(piece, seen);
    seen = std::max(seen, piece + 1);
  }
  EXPECT_EQ(seen, 7);
}

TEST(DealByMetis, TakesFewTiles) {
  EXPECT_EQ(deal_by_metis({{5}, {}}, 4), std::vector<int>{0});
  EXPECT_EQ(deal_by_metis({}, 4), std::vector<int>{});
  EXPECT_EQ(deal_by_metis(grid_of_tiles(2, 1, 1), 1), std::vector<int>(4, 0));
}

}  // namespace
}  // namespace surfmesh
