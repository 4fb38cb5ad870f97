// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_plan.hh"

#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/estimate/element_limit.hh"
#include "surfmesh/estimate/estimate_triangles.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"
#include "surfmesh/pipeline/fine_cage.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/quad/improper_quads.hh"

namespace surfmesh::detail {

void MeshPlan::take_spaces(ControlSpaces made) {
  const StageClock clock(report_.seconds[Stage::Control]);
  append(std::move(made.notices), report_.notices);
  spaces_ = std::move(made.spaces);
  report_.control.kind = effective_kind(options_.control);
  report_.control.precision = made.precision;
  count_nodes();
  make_fields();
  estimate();
  if (auto notice = notice_of_fine_cage(model_, fields_)) {
    report_.notices.push_back(std::move(*notice));
  }
}

void MeshPlan::make_fields() {
  surface_fields_.clear();
  fields_.clear();
  for (std::size_t p = 0; p < spaces_.size(); ++p) {
    surface_fields_.push_back(
        std::make_unique<SurfaceMetricField>(*model_.patches[p].surface, *spaces_[p]));
    fields_.push_back(surface_fields_.back().get());
  }
}

void MeshPlan::keep_spaces(const std::vector<char>& is_kept) {
  for (std::size_t p = 0; p < spaces_.size(); ++p) {
    if (is_kept[p] != 0) continue;
    fields_[p] = nullptr;
    surface_fields_[p].reset();
    spaces_[p].reset();
  }
}

void MeshPlan::restore_spaces(ControlSpaces made) {
  const StageClock clock(report_.seconds[Stage::Control]);
  spaces_ = std::move(made.spaces);
  make_fields();
}

void MeshPlan::count_nodes() {
  for (const std::unique_ptr<ControlSpace>& space : spaces_) {
    const PolyMesh& mesh = space->mesh();
    report_.control.nodes += mesh.n_vertices();
    report_.control.faces += mesh.n_faces();
    count_classes(mesh);
  }
}

void MeshPlan::count_classes(const PolyMesh& mesh) {
  const auto handle = find(mesh, keys::face_class);
  if (!handle.is_valid()) return;
  Report::Classes& classes = report_.control.classes;
  for (const FaceHandle fh : mesh.faces()) {
    switch (static_cast<Interpolation>(mesh.property(handle, fh))) {
      case Interpolation::Single:
        ++classes.single;
        break;
      case Interpolation::Triangle:
        ++classes.triangle;
        break;
      case Interpolation::Linear:
        ++classes.linear;
        break;
      default:
        ++classes.circles;
    }
  }
}

/// What would surely be too much is refused before any memory is taken for it.
void MeshPlan::estimate() {
  const TriangleEstimate estimate =
      estimate_triangles(model_, spaces_, sizing_.bounds.hmin, context_);
  report_.estimated_elements = estimated_elements(estimate, context_);
  triangles_of_patches_ = estimate.triangles_of_patches();
  if (is_surely_above(estimate, context_)) throw_too_many(estimate, sizing_.bounds.hmax, context_);
  const auto elements = static_cast<std::size_t>(report_.estimated_elements);
  context_.tell("estimate", elements, elements);
}

void MeshPlan::divide(const ContourDemands& demands, double corrected_sag, PatchCache* cache) {
  const StageClock clock(report_.seconds[Stage::Boundary]);
  corrected_sag_ = corrected_sag;
  cache_ = cache;
  context_.tell("boundary", 0, model_.contours.size());
  place_nodes(demands);
  cut_into_tiles(demands.sag.value_or(0));
  context_.tell("boundary", model_.contours.size(), model_.contours.size());
}

void MeshPlan::place_nodes(const ContourDemands& demands) {
  BoundaryNodes boundary =
      place_contour_nodes(model_, fields_, demands, context_, known_contours());
  nodes_ = std::move(boundary.contours);
  report_.control.queries[Stage::Boundary] = boundary.report.queries;
  numbers_ = std::make_unique<NodeNumbers>(model_, nodes_);
}

/// The contours between patches whose sizes are as they were; null if none are kept.
ContourMemory* MeshPlan::known_contours() {
  if (!cache_) return nullptr;
  std::vector<char> is_changed(spaces_.size(), 0);
  share_indices(spaces_.size(), [&](std::size_t p) {
    is_changed[p] = cache_->begin(p, spaces_[p]->mesh()) ? 0 : 1;
  });
  cache_->contours().forget_changed(model_, is_changed);
  return &cache_->contours();
}

void MeshPlan::cut_into_tiles(double sag) {
  tiles_ = cut_patches(model_, fields_, nodes_, *numbers_,
                       {.triangles = triangles_of_patches_,
                        .most = static_cast<double>(options_.tile),
                        .multiple = options_.quads.is_on ? 2 : 1,
                        .sag = sag},
                       context_);
  report_.tiles = {tiles_.tiles.size(), tiles_.refused};
  report_.control.queries[Stage::Boundary] += tiles_.queries;
}

PatchResult MeshPlan::mesh_tile(std::size_t t, const RunContext& context) const {
  const Tile& tile = tiles_.tiles[t];
  const auto p = static_cast<std::size_t>(tile.boundary.patch);
  const Surface& surface = *model_.patches[p].surface;
  const SurfaceMetricField of_tile(surface, *spaces_[p], tile.required_points);
  PatchTask task{.surface = surface,
                 .field = tiles_.is_whole(p) ? *fields_[p] : of_tile,
                 .boundary = tile.boundary,
                 .refine = options_.refine,
                 .improve = options_.improve,
                 .corrected_sag = corrected_sag_,
                 .stretch = sizing_.stretch,
                 .quads = options_.quads};
  PatchResult result;
  at_patch(model_.patches[p], [&] {
    result = cache_ ? mesh_unless_kept({p, t - tiles_.first[p]}, std::move(task))
                    : mesh_patch(std::move(task), context);
    const StageClock clock(result.seconds[Stage::Assemble]);
    std::vector<PatchMesh> alone;
    alone.push_back(std::move(result.mesh));
    const auto turned = make_proper(alone);
    result.mesh = std::move(alone.front());
    if (!turned.empty()) result.turned = turned.begin()->second;
  });
  return result;
}

std::map<std::size_t, TurnedTriangles> MeshPlan::make_proper(std::vector<PatchMesh>& tiles) const {
  if (!options_.quads.is_on) return split_improper_chords(tiles, model_, fields_).turned;
  mend_improper_quads(tiles, model_, fields_);
  return {};
}

PatchResult MeshPlan::mesh_unless_kept(TilePlace place, PatchTask task) const {
  if (auto kept = cache_->find(place, task)) {
    context_.add_elements(kept->mesh.mesh->n_faces());
    return std::move(*kept);
  }
  PatchResult result = mesh_patch(std::move(task), context_);
  cache_->keep(place, corrected_sag_, result);
  return result;
}

}  // namespace surfmesh::detail
