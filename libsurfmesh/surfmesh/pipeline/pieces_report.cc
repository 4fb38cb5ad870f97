// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/pieces_report.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/pipeline/face_notices.hh"
#include "surfmesh/pipeline/tile_notices.hh"
#include "surfmesh/quality/patch_measures.hh"

namespace surfmesh::detail {
namespace {

/// The edges of a mesh: half of its sides, but for those on contours, which have a side for each
/// use.
long edge_count(const Model& model, const std::vector<ContourNodes>& nodes,
                const SummaryOfTiles& all) {
  long sides_inside = static_cast<long>(3 * all.triangles + 4 * all.quads);
  long on_contours = 0;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (contour.is_degenerate || contour.uses.empty()) continue;
    const long segments = nodes[c].segment_count();
    sides_inside -= std::ssize(contour.uses) * segments;
    on_contours += segments;
  }
  return sides_inside / 2 + on_contours;
}

/// True if there is no contour with a patch on one side only.
bool is_closed(const Model& model) {
  return std::none_of(model.contours.begin(), model.contours.end(), [](const Contour& contour) {
    return !contour.is_degenerate && contour.uses.size() == 1;
  });
}

Report::Mesh mesh_of(const PiecesPlan& plan, const SummaryOfTiles& all, std::int64_t vertices) {
  const Model& model = plan.model();
  const std::size_t faces = all.triangles + all.quads;
  const long euler = static_cast<long>(vertices) - edge_count(model, plan.mesh().nodes(), all) +
                     static_cast<long>(faces);
  return {.vertices = static_cast<std::size_t>(vertices),
          .triangles = all.triangles,
          .quads = all.quads,
          .patches = model.patches.size(),
          .is_closed = faces > 0 && is_closed(model),
          .euler = euler};
}

std::optional<Report::WorstFace> place_of(const Model& model,
                                          const std::vector<TileSummary>& summaries,
                                          std::ptrdiff_t tile, FacePlace TileSummary::*place) {
  if (tile < 0) return {};
  const TileSummary& summary = summaries[static_cast<std::size_t>(tile)];
  const FacePlace& at = summary.*place;
  return Report::WorstFace{model.patch(static_cast<int>(summary.patch)).name, {at.x, at.y, at.z}};
}

void take_sums(const Model& model, const std::vector<TileSummary>& summaries,
               const SummaryOfTiles& all, Report& report) {
  report.edges = all.edges;
  report.quality = all.quality;
  report.quads = all.quad_statistics;
  report.lengths = {all.lengths.min, all.lengths.moments.mean(), all.lengths.max};
  report.refine = all.refine;
  report.worst = place_of(model, summaries, all.worst, &TileSummary::worst);
  report.worst_quad = place_of(model, summaries, all.worst_quad, &TileSummary::worst_quad);
  report.worst_quad_in_space =
      place_of(model, summaries, all.worst_quad_in_space, &TileSummary::worst_quad_in_space);
}

/// The name, the groups and the least qualities of each patch.
std::vector<PatchMeasure> named_patches(const Model& model, const SummaryOfTiles& all) {
  const MeshNames names = mesh_names(model);
  const auto groups = groups_by_patch(names, model.patches.size());
  std::vector<PatchMeasure> patches(model.patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    patches[p].name = model.patches[p].name;
    for (const int group : groups[p]) {
      patches[p].groups.push_back(names.groups[static_cast<std::size_t>(group)].name);
    }
    const double quality = all.quality.min_of_patches[p];
    const double jacobian = all.quad_statistics.min_of_patches[p];
    if (std::isfinite(quality)) patches[p].least_quality = quality;
    if (std::isfinite(jacobian)) patches[p].least_jacobian = jacobian;
  }
  return patches;
}

void add_tiles(const std::vector<TileSummary>& summaries, std::vector<PatchMeasure>& patches) {
  for (const TileSummary& summary : summaries) {
    PatchMeasure& patch = patches[static_cast<std::size_t>(summary.patch)];
    patch.triangles += static_cast<std::size_t>(summary.triangles);
    patch.quads += static_cast<std::size_t>(summary.quads);
    patch.area += summary.area;
  }
}

TurnedTile turned_of(const TileSummary& summary) {
  TurnedTile tile{static_cast<int>(summary.patch), {}};
  tile.turned.count = static_cast<std::size_t>(summary.turned);
  if (summary.has_turned_place == 0) return tile;
  const FacePlace& at = summary.turned_at;
  tile.turned.place = TurnedPlace{
      {summary.turned_u, summary.turned_v}, {at.x, at.y, at.z}, summary.is_turned_by_surface != 0};
  return tile;
}

std::optional<ToldFace> told(const std::vector<TileSummary>& summaries, std::ptrdiff_t tile,
                             FacePlace TileSummary::*place) {
  if (tile < 0) return {};
  const TileSummary& summary = summaries[static_cast<std::size_t>(tile)];
  const FacePlace& at = summary.*place;
  return ToldFace{static_cast<int>(summary.patch), Vec3(at.x, at.y, at.z)};
}

/// A triangle of the first tile that has one; the place of what is left of a quad is not known.
std::optional<ToldFace> told_triangle(const std::vector<TileSummary>& summaries) {
  const auto first = std::find_if(summaries.begin(), summaries.end(),
                                  [](const TileSummary& tile) { return tile.triangles > 0; });
  if (first == summaries.end()) return {};
  if (first->has_triangle_place == 0) return ToldFace{static_cast<int>(first->patch), {}};
  return told(summaries, first - summaries.begin(), &TileSummary::triangle_at);
}

ToldFaces told_faces(const std::vector<TileSummary>& summaries, const SummaryOfTiles& all) {
  return {.worst = told(summaries, all.worst, &TileSummary::worst),
          .worst_quad = told(summaries, all.worst_quad, &TileSummary::worst_quad),
          .worst_quad_in_space =
              told(summaries, all.worst_quad_in_space, &TileSummary::worst_quad_in_space),
          .triangle = told_triangle(summaries)};
}

void tell(const PiecesPlan& plan, const std::vector<TileSummary>& summaries, Notices& notices) {
  const Model& model = plan.model();
  std::vector<char> is_given_up(model.patches.size(), 0);
  std::vector<TurnedTile> turned;
  for (const TileSummary& summary : summaries) {
    if (summary.is_given_up != 0) is_given_up[static_cast<std::size_t>(summary.patch)] = 1;
    turned.push_back(turned_of(summary));
  }
  append(notices_of_given_up(model, is_given_up, plan.context().element_kind()), notices);
  if (!plan.options().quads.is_on) append(notices_of_turned(model, turned), notices);
}

}  // namespace

void report_tiles(const PiecesPlan& plan, const std::vector<TileSummary>& summaries,
                  std::int64_t vertices, Report& report) {
  const Model& model = plan.model();
  const SummaryOfTiles all = sum_of(summaries, model.patches.size());
  report.mesh = mesh_of(plan, all, vertices);
  report.diagonal = model.diagonal;
  report.tolerance = greatest_tolerance(model);
  take_sums(model, summaries, all, report);
  report.patches = named_patches(model, all);
  add_tiles(summaries, report.patches);
  tell(plan, summaries, report.notices);
  append(notices_of_faces(model, report, told_faces(summaries, all)), report.notices);
}

void count_shared(const PiecesPlan& plan, Report::Pieces& pieces) {
  pieces.count = static_cast<std::size_t>(plan.deal().pieces);
  pieces.of_several_pieces = plan.shared().of_several_pieces();
  pieces.of_several_ranks = plan.shared().of_several_ranks();
}

}  // namespace surfmesh::detail
