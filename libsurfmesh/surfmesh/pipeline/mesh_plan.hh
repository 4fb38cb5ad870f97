// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/patch/mesh_patch.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/model_tiles.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/pipeline/patch_cache.hh"
#include "surfmesh/pipeline/report.hh"

namespace surfmesh::detail {

/// What is known of the mesh of a model before its tiles are meshed: the sizes, the nodes on
/// contours, and the tiles, each of which can then be meshed by itself.
///
/// Model, sizing, options, context and report must outlive the plan; the report gets the notices,
/// seconds and queries of all that is done.
class MeshPlan {
 public:
  MeshPlan(const Model& model, const ResolvedSizing& sizing, const PipelineOptions& options,
           const RunContext& context, Report& report)
      : model_(model), sizing_(sizing), options_(options), context_(context), report_(report) {}

  /// Take the control spaces of all patches, and estimate from them how many elements there will
  /// be.
  /// Throws   Limit if that is surely too many
  void take_spaces(ControlSpaces made);

  /// Place the nodes on contours, and cut large patches into tiles.
  ///
  /// Patches and contours that the cache knows are as they were; null for none. `corrected_sag` is
  /// that of the tiles, see PatchTask.
  /// Throws   as place_contour_nodes and cut_patches
  void divide(const ContourDemands& demands, double corrected_sag, PatchCache* cache);

  /// Drop the control spaces of all but some patches, by patch 1 for those that stay: tiles of the
  /// others cannot be meshed until restore_spaces().
  void keep_spaces(const std::vector<char>& is_kept);

  /// Take the same control spaces again as in take_spaces().
  void restore_spaces(ControlSpaces made);

  bool has_space(std::size_t patch) const { return spaces_[patch] != nullptr; }

  /// Mesh a tile, which by itself makes no edge of the result improper.
  ///
  /// Tiles may be meshed by several threads at once, and again. `context` counts the elements.
  /// Throws   as mesh_patch; the patch is named
  PatchResult mesh_tile(std::size_t tile, const RunContext& context) const;

  /// Mend where the meshes of several tiles make the result improper together; see
  /// split_improper_chords and mend_improper_quads.
  ///
  /// Returns  what is turned in tiles that have changed, by their places in the list
  std::map<std::size_t, TurnedTriangles> make_proper(std::vector<PatchMesh>& tiles) const;

  const std::vector<const MetricField*>& fields() const { return fields_; }
  const std::vector<ContourNodes>& nodes() const { return nodes_; }
  const NodeNumbers& numbers() const { return *numbers_; }
  const std::vector<Tile>& tiles() const { return tiles_.tiles; }

 private:
  void make_fields();
  void count_nodes();
  void count_classes(const PolyMesh& mesh);
  void estimate();
  void place_nodes(const ContourDemands& demands);
  ContourMemory* known_contours();
  void cut_into_tiles(double sag);
  PatchResult mesh_unless_kept(TilePlace place, PatchTask task) const;

  const Model& model_;
  const ResolvedSizing& sizing_;
  const PipelineOptions& options_;
  const RunContext& context_;
  Report& report_;
  PatchCache* cache_ = nullptr;
  double corrected_sag_ = 0;
  std::vector<std::unique_ptr<ControlSpace>> spaces_;
  std::vector<std::unique_ptr<SurfaceMetricField>> surface_fields_;
  std::vector<const MetricField*> fields_;
  std::vector<double> triangles_of_patches_;  ///< that are estimated
  std::vector<ContourNodes> nodes_;
  std::unique_ptr<NodeNumbers> numbers_;
  ModelTiles tiles_;
};

}  // namespace surfmesh::detail
