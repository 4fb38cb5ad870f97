// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/improper_tiles.hh"

#include <map>
#include <set>

namespace surfmesh {
namespace {

/// The tiles that have an edge between the same two vertices.
using TilesAtEdges = std::map<EdgeEnds, std::set<std::size_t>>;

TilesAtEdges gather_chords(const std::vector<TileEdge>& own, Exchange& exchange) {
  TilesAtEdges tiles_at;
  for (const std::vector<TileEdge>& of_rank : gather_all(exchange, own)) {
    for (const TileEdge& edge : of_rank) {
      tiles_at[edge.ends].insert(static_cast<std::size_t>(edge.tile));
    }
  }
  return tiles_at;
}

/// Add the tiles whose boundaries have a segment between vertices that a chord joins.
void add_segments(const std::vector<Tile>& tiles, TilesAtEdges& tiles_at) {
  if (tiles_at.empty()) return;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const BoundaryLoop& loop : tiles[t].boundary.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int from = loop[i].vertex, to = loop[i + 1 == loop.size() ? 0 : i + 1].vertex;
        if (from < 0 || to < 0) continue;
        const auto found = tiles_at.find(edge_ends(from, to));
        if (found != tiles_at.end()) found->second.insert(t);
      }
    }
  }
}

}  // namespace

std::vector<std::size_t> improper_tiles(const std::vector<Tile>& tiles,
                                        const std::vector<TileEdge>& own_chords,
                                        Exchange& exchange) {
  TilesAtEdges tiles_at = gather_chords(own_chords, exchange);
  add_segments(tiles, tiles_at);
  std::set<std::size_t> involved;
  for (const auto& [ends, there] : tiles_at) {
    if (there.size() > 1) involved.insert(there.begin(), there.end());
  }
  return {involved.begin(), involved.end()};
}

}  // namespace surfmesh
