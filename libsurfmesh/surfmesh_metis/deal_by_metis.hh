// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/pieces/partition.hh"

namespace surfmesh {

/// Deal tiles so that few nodes are in more than one piece, and no piece is more than about 3 %
/// heavier than the mean where the tiles allow that. Pieces are numbered by their first tiles.
/// METIS may make fewer than `pieces`, mostly where they have few tiles: the last ones are empty
/// then. A DealTiles.
///
/// Cost     some milliseconds for a thousand tiles
/// Throws   Limit if METIS has no memory
/// Source   Karypis, Kumar, A fast and high quality multilevel scheme for partitioning irregular
///          graphs (1998)
std::vector<int> deal_by_metis(const TileGraph& graph, int pieces);

/// The version of METIS: "5.1.0".
std::string metis_version();

}  // namespace surfmesh
