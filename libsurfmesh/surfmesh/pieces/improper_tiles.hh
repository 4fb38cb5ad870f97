// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"
#include "surfmesh/tiles/cut_into_tiles.hh"

namespace surfmesh {

/// An edge of a tile, as ranks exchange them.
struct TileEdge {
  std::int64_t tile;
  EdgeEnds ends;
};

/// Find the tiles with an edge between two vertices that a chord of another tile joins, too: what
/// each of them made is proper, but not all of it together.
///
/// Called by all ranks, with the chords of their own tiles; see SharedEdges.
/// Returns  the numbers of the tiles, ascending; the same on all ranks
/// Cost     O(n log n) for the chords of all tiles, O(boundary nodes) if there are any
std::vector<std::size_t> improper_tiles(const std::vector<Tile>& tiles,
                                        const std::vector<TileEdge>& own_chords,
                                        Exchange& exchange);

}  // namespace surfmesh
