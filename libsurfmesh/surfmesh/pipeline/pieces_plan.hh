// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pieces/deal_tiles.hh"
#include "surfmesh/pieces/shared_numbers.hh"
#include "surfmesh/pipeline/mesh_pieces.hh"
#include "surfmesh/pipeline/mesh_plan.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/pipeline/report.hh"
#include "surfmesh/sizes/resolved_sizing.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::detail {

/// What every rank of a run in pieces makes by itself, and alike: control spaces, nodes on
/// contours, tiles, who meshes them, and the numbers of the vertices that they share.
///
/// Model, sources, options and context must outlive the plan.
class PiecesPlan {
 public:
  PiecesPlan(const Model& model, const Sources& sources, const PipelineOptions& options,
             const RunContext& context);

  /// Throws   as make_control_spaces, place_contour_nodes and cut_patches
  void make(const PiecesOptions& pieces, int ranks);

  /// Drop the control spaces of patches of which a rank has no tiles.
  void drop_other_spaces(int rank);

  /// Have the control spaces of all these tiles, if need be by making all of them again.
  void need_spaces(const std::vector<std::size_t>& tiles);

  const Model& model() const { return model_; }
  const RunContext& context() const { return context_; }
  const PipelineOptions& options() const { return options_; }  ///< those that take effect
  const MeshPlan& mesh() const { return mesh_; }
  const std::vector<Tile>& tiles() const { return mesh_.tiles(); }
  const TileDeal& deal() const { return deal_; }
  const SharedNumbers& shared() const { return *shared_; }

  /// Of what was done so far.
  const Report& report() const { return report_; }

 private:
  std::size_t patch_of(std::size_t tile) const;
  void begin_report();
  ControlSpaces control_spaces();
  void divide();

  const Model& model_;
  const Sources& sources_;
  const PipelineOptions& asked_;
  PipelineOptions options_;
  const RunContext& context_;
  ResolvedSizing sizing_;
  Report report_;
  MeshPlan mesh_;
  TileDeal deal_;
  std::optional<SharedNumbers> shared_;
};

}  // namespace surfmesh::detail
