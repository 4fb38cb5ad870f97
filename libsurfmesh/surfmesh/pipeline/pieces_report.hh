// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "surfmesh/pieces/tile_summary.hh"
#include "surfmesh/pipeline/pieces_plan.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh::detail {

/// Fill the report of a mesh in pieces from the summaries of all its tiles: the same on every rank.
///
/// `vertices` is the number of them in the whole mesh. The mesh is closed, and has an Euler
/// characteristic, as the pieces are joined by the ids of their vertices: also along contours at
/// which a half-edge mesh has to be cut.
/// Cost     O(tiles + contours)
void report_tiles(const PiecesPlan& plan, const std::vector<TileSummary>& summaries,
                  std::int64_t vertices, Report& report);

/// How many vertices several pieces have, and several ranks: from the boundaries of tiles alone.
/// Writes   Report::Pieces::count, of_several_pieces and of_several_ranks
void count_shared(const PiecesPlan& plan, Report::Pieces& pieces);

}  // namespace surfmesh::detail
