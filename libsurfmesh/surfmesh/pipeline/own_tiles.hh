// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "surfmesh/core/stage.hh"
#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"
#include "surfmesh/pieces/tile_part.hh"
#include "surfmesh/pieces/tile_summary.hh"
#include "surfmesh/pipeline/pieces_plan.hh"

namespace surfmesh::detail {

/// Meshes the tiles of a rank, and keeps of each what its piece needs.
///
/// The plan must outlive it. All ranks call the functions that exchange something together.
class OwnTiles {
 public:
  OwnTiles(PiecesPlan& plan, Exchange& exchange);

  /// Mesh all tiles of this rank.
  /// Throws   AgreedError: that of the least tile of all ranks, but Cancelled before all others
  void mesh();

  /// Mesh tiles anew whose edges join what those of others join, together: few, if there are any.
  /// Throws   AgreedError, as well of Geometry if that does not end
  void mend_edges();

  /// The summaries of the tiles of all ranks, in their order.
  std::vector<TileSummary> gather_summaries() const;

  /// The part of a tile of this rank.
  const TilePart& part(std::size_t tile) const { return tiles_[tile].part; }

  /// Hand the part of a tile over: it is not here afterwards.
  TilePart take_part(std::size_t tile);

  const PerStage<double>& seconds() const { return seconds_; }
  const PerStage<QueryCounts>& queries() const { return queries_; }

 private:
  /// What is kept of a tile of this rank.
  struct OwnTile {
    TilePart part;
    TileSummary summary;
    std::vector<EdgeEnds> chords;
  };

  bool is_own(std::size_t tile) const { return plan_.deal().rank_of(tile) == exchange_.rank(); }
  void mesh_own();
  void check_count();
  void keep(std::size_t tile, PatchResult result);
  std::vector<std::size_t> find_improper() const;
  void mesh_together(const std::vector<std::size_t>& tiles);

  PiecesPlan& plan_;
  Exchange& exchange_;
  std::vector<char> is_turned_;  ///< by patch
  std::vector<OwnTile> tiles_;   ///< by tile; those of other ranks are empty
  std::mutex mutex_;             ///< of the seconds and queries
  PerStage<double> seconds_;
  PerStage<QueryCounts> queries_;
};

}  // namespace surfmesh::detail
