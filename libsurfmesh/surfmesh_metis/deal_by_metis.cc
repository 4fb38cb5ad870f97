// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_metis/deal_by_metis.hh"

#include <fmt/format.h>
#include <metis.h>

#include <cmath>
#include <numeric>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// METIS adds weights up as numbers of 32 bits.
constexpr double kWholeWeight = 1 << 24;

std::vector<idx_t> whole_weights(const std::vector<double>& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<idx_t> whole;
  for (const double weight : weights) {
    whole.push_back(
        1 + (total > 0 ? static_cast<idx_t>(std::lround(kWholeWeight * weight / total)) : 0));
  }
  return whole;
}

/// The tiles beside each tile, with the nodes in common, as METIS takes them.
struct Adjacency {
  std::vector<idx_t> first, tiles, nodes;
};

Adjacency adjacency_of(const TileGraph& graph) {
  Adjacency result;
  result.first.resize(graph.weights.size() + 1);
  const auto place = [&](int tile) -> idx_t& {
    return result.first[static_cast<std::size_t>(tile)];
  };
  for (const TileNeighbours& pair : graph.neighbours) {
    ++place(pair.first + 1);
    ++place(pair.second + 1);
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.tiles.resize(2 * graph.neighbours.size());
  result.nodes.resize(result.tiles.size());
  std::vector<idx_t> next = result.first;
  const auto add = [&](int tile, int other, int nodes) {
    const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(tile)]++);
    result.tiles[at] = other;
    result.nodes[at] = nodes;
  };
  for (const TileNeighbours& pair : graph.neighbours) {
    add(pair.first, pair.second, pair.nodes);
    add(pair.second, pair.first, pair.nodes);
  }
  return result;
}

/// Number the pieces in the order in which tiles name them.
std::vector<int> in_order_of_tiles(const std::vector<idx_t>& piece_of, int pieces) {
  std::vector<int> number(static_cast<std::size_t>(pieces), -1);
  std::vector<int> numbered;
  int next = 0;
  for (const idx_t piece : piece_of) {
    int& known = number[static_cast<std::size_t>(piece)];
    if (known < 0) known = next++;
    numbered.push_back(known);
  }
  return numbered;
}

}  // namespace

std::vector<int> deal_by_metis(const TileGraph& graph, int pieces) {
  const std::size_t count = graph.weights.size();
  if (pieces == 1 || count < 2) return std::vector<int>(count, 0);
  Adjacency beside = adjacency_of(graph);
  std::vector<idx_t> weights = whole_weights(graph.weights), piece_of(count);
  auto tile_count = static_cast<idx_t>(count);
  idx_t constraints = 1, piece_count = pieces, cut = 0;
  std::vector<idx_t> options(METIS_NOPTIONS);
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 0;
  const int result = METIS_PartGraphKway(
      &tile_count, &constraints, beside.first.data(), beside.tiles.data(), weights.data(), nullptr,
      beside.nodes.data(), &piece_count, nullptr, nullptr, options.data(), &cut, piece_of.data());
  if (result != METIS_OK) throw Error(ErrorCode::Limit, "METIS cannot deal out the tiles");
  return in_order_of_tiles(piece_of, pieces);
}

std::string metis_version() {
  return fmt::format("{}.{}.{}", METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR);
}

}  // namespace surfmesh
