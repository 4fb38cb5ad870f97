// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/deal_tiles.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace surfmesh {
namespace {

/// Triangles of a piece if there is one rank: some 80 MB in a file.
constexpr double kTrianglesOfPiece = 2e6;

std::vector<double> weights_of(const std::vector<Tile>& tiles) {
  std::vector<double> weights;
  for (const Tile& tile : tiles) weights.push_back(std::max(1.0, tile.triangles));
  return weights;
}

/// By vertex, the tiles that have it on their boundary, ascending.
std::unordered_map<int, std::vector<int>> tiles_at_vertices(const std::vector<Tile>& tiles) {
  std::unordered_map<int, std::vector<int>> tiles_at;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const BoundaryLoop& loop : tiles[t].boundary.loops) {
      for (const BoundaryNode& node : loop) {
        if (node.vertex < 0) continue;
        std::vector<int>& there = tiles_at[node.vertex];
        if (there.empty() || there.back() != static_cast<int>(t)) {
          there.push_back(static_cast<int>(t));
        }
      }
    }
  }
  return tiles_at;
}

/// How many nodes each two tiles have in common.
TileGraph graph_of(const std::vector<Tile>& tiles) {
  std::map<std::pair<int, int>, int> common;
  for (const auto& [vertex, there] : tiles_at_vertices(tiles)) {
    for (std::size_t i = 0; i < there.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) ++common[{there[j], there[i]}];
    }
  }
  TileGraph graph{weights_of(tiles), {}};
  for (const auto& [pair, nodes] : common) {
    graph.neighbours.push_back({pair.first, pair.second, nodes});
  }
  return graph;
}

int piece_count(const std::vector<double>& weights, int asked, int ranks) {
  const double triangles = std::accumulate(weights.begin(), weights.end(), 0.0);
  const int wanted = asked > 0   ? asked
                     : ranks > 1 ? ranks
                                 : static_cast<int>(std::ceil(triangles / kTrianglesOfPiece));
  return std::clamp(wanted, 1, std::max(1, static_cast<int>(weights.size())));
}

}  // namespace

TileDeal deal_out(const std::vector<Tile>& tiles, int pieces, const DealTiles& deal, int ranks) {
  const std::vector<double> weights = weights_of(tiles);
  TileDeal dealt;
  dealt.pieces = piece_count(weights, pieces, ranks);
  dealt.piece_of = deal ? deal(graph_of(tiles), dealt.pieces) : deal_in_runs(weights, dealt.pieces);
  std::vector<double> of_pieces(static_cast<std::size_t>(dealt.pieces), 0);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    of_pieces[static_cast<std::size_t>(dealt.piece_of[t])] += weights[t];
  }
  dealt.rank_of_piece = deal_in_runs(of_pieces, ranks);
  return dealt;
}

}  // namespace surfmesh
