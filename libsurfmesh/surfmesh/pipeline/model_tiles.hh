// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/tiles/cut_into_tiles.hh"

namespace surfmesh::detail {

/// What the tiles of all patches depend on, besides the nodes on contours.
struct TileRules {
  std::vector<double> triangles;  ///< by patch, that it will have
  double most = 0;                ///< triangles of a tile; 0 is off
  int multiple = 1;               ///< of the number of nodes around each: 2 for quads
  double sag = 0;                 ///< greatest distance of cuts, model units; 0 is off
};

/// The tiles of a model, in the order of its patches.
struct ModelTiles {
  std::vector<Tile> tiles;
  std::vector<std::size_t> first;  ///< tile of each patch, and behind the last one
  std::size_t refused = 0;         ///< see Tiles::refused
  QueryCounts queries;

  bool is_whole(std::size_t patch) const { return first[patch + 1] == first[patch] + 1; }
};

/// Collect the boundaries of all patches and cut those of large ones into tiles. Nodes that tiles
/// share get numbers of their own.
///
/// Cost     see cut_into_tiles; shared among threads by patch
/// Throws   Cancelled; Geometry, naming the patch
ModelTiles cut_patches(const Model& model, const std::vector<const MetricField*>& fields,
                       const std::vector<ContourNodes>& nodes, NodeNumbers& numbers,
                       const TileRules& rules, const RunContext& context);

/// The indices of tiles, the one of most triangles first.
std::vector<std::size_t> largest_first(const std::vector<Tile>& tiles);

}  // namespace surfmesh::detail
