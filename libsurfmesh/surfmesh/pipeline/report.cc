// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/report.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <new>
#include <numeric>
#include <string_view>
#include <utility>
#include <variant>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/io/json.hh"
#include "surfmesh/pipeline/notice_json.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/pipeline/statistics_json.hh"

namespace surfmesh {
namespace {

Json options_json(const PipelineOptions& options) {
  Json json = Json::object();
  for (const std::string_view name : option_names()) {
    std::visit([&](const auto& value) { json[std::string(name)] = value; },
               get_option(options, name));
  }
  return json;
}

Json notices_json(const Report& report) {
  return detail::notices_json(report.notices, [&report](int patch) {
    const auto p = static_cast<std::size_t>(patch);
    return p < report.patches.size() ? report.patches[p].name : std::string();
  });
}

Json mesh_json(const Report::Mesh& mesh) {
  return {{"vertices", mesh.vertices}, {"triangles", mesh.triangles}, {"quads", mesh.quads},
          {"patches", mesh.patches},   {"closed", mesh.is_closed},    {"euler", mesh.euler}};
}

/// Null where nothing is cut, as for an estimate of the number of elements alone.
Json tiles_json(const Report::Tiles& tiles) {
  if (tiles.count == 0) return nullptr;
  return {{"count", tiles.count}, {"refused", tiles.refused}};
}

/// Null for a mesh in one piece.
Json pieces_json(const std::optional<Report::Pieces>& pieces) {
  if (!pieces) return nullptr;
  Json seconds = nullptr;
  if (!pieces->seconds_of_ranks.empty()) seconds = pieces->seconds_of_ranks;
  return {{"count", pieces->count},
          {"ranks", pieces->faces_of_ranks.size()},
          {"faces_of_ranks", pieces->faces_of_ranks},
          {"largest_share", pieces->largest_share()},
          {"seconds_of_ranks", seconds},
          {"vertices_of_several_pieces", pieces->of_several_pieces},
          {"vertices_of_several_ranks", pieces->of_several_ranks},
          {"bytes_sent", pieces->bytes_sent}};
}

/// Null for what is not known.
template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json files_json(const std::vector<std::filesystem::path>& files) {
  Json json = Json::array();
  for (const std::filesystem::path& file : files) json.push_back(file.string());
  return json;
}

Json given_json(const std::vector<GivenOption>& given) {
  Json json = Json::object();
  for (const GivenOption& option : given) {
    json[option.name] = {{"value", option.value}, {"from", name(option.origin)}};
  }
  return json;
}

/// The sums of a group over its patches.
struct GroupMeasure {
  std::string name;
  std::size_t patches = 0;
  std::size_t triangles = 0;
  std::size_t quads = 0;
  double area = 0;
  std::optional<double> least_quality = std::nullopt;
  std::optional<double> least_jacobian = std::nullopt;
};

/// Make a least value, if there is one, the least of it and another.
void take_least(const std::optional<double>& value, std::optional<double>& least) {
  if (value) least = std::min(least.value_or(*value), *value);
}

void add_patch(const PatchMeasure& patch, GroupMeasure& group) {
  ++group.patches;
  group.triangles += patch.triangles;
  group.quads += patch.quads;
  group.area += patch.area;
  take_least(patch.least_quality, group.least_quality);
  take_least(patch.least_jacobian, group.least_jacobian);
}

/// In the order in which patches name them.
std::vector<GroupMeasure> measure_groups(const std::vector<PatchMeasure>& patches) {
  std::vector<GroupMeasure> groups;
  std::map<std::string, std::size_t> index_of;
  for (const PatchMeasure& patch : patches) {
    for (const std::string& name : patch.groups) {
      const auto [found, is_new] = index_of.emplace(name, groups.size());
      if (is_new) groups.push_back({.name = name});
      add_patch(patch, groups[found->second]);
    }
  }
  return groups;
}

Json groups_json(const std::vector<PatchMeasure>& patches) {
  Json json = Json::array();
  for (const GroupMeasure& group : measure_groups(patches)) {
    json.push_back({{"name", group.name},
                    {"patches", group.patches},
                    {"triangles", group.triangles},
                    {"quads", group.quads},
                    {"area", group.area},
                    {"least_quality", or_null(group.least_quality)},
                    {"least_scaled_jacobian", or_null(group.least_jacobian)}});
  }
  return json;
}

Json worst_json(const std::optional<Report::WorstFace>& worst) {
  if (!worst) return nullptr;
  return {{"patch", worst->patch},
          {"point", {worst->point.x(), worst->point.y(), worst->point.z()}}};
}

Json patches_json(const std::vector<PatchMeasure>& patches) {
  Json json = Json::array();
  for (const PatchMeasure& patch : patches) {
    json.push_back({{"name", patch.name},
                    {"groups", patch.groups},
                    {"triangles", patch.triangles},
                    {"quads", patch.quads},
                    {"area", patch.area},
                    {"least_quality", or_null(patch.least_quality)},
                    {"least_scaled_jacobian", or_null(patch.least_jacobian)}});
  }
  return json;
}

/// The cages whose surfaces pass through their points.
Json surfaces_json(const std::vector<SurfaceFit>& surfaces) {
  Json json = Json::array();
  for (const SurfaceFit& fit : surfaces) {
    json.push_back({{"part", fit.part},
                    {"vertices", fit.vertices},
                    {"fit", fit.fit},
                    {"greatest_distance", fit.distance},
                    {"mean_distance", fit.mean_distance},
                    {"greatest_move", fit.greatest_move},
                    {"moved_vertex", fit.moved_vertex},
                    {"creases", fit.creases},
                    {"corners", fit.corners},
                    {"wavy_share", fit.wavy_share},
                    {"greatest_wave", fit.greatest_wave},
                    {"noisy_share", fit.noisy_share}});
  }
  return json;
}

/// Null without triangles, as quads_json is without quads.
Json quality_json(const Report& report) {
  if (report.quality.count == 0) return nullptr;
  return {{"min", report.quality.min},
          {"mean", report.quality.mean},
          {"below_0.3", report.quality.below_0_3},
          {"histogram", detail::histogram_json(report.quality.histogram)},
          {"worst", worst_json(report.worst)}};
}

Json quads_json(const Report& report) {
  const QuadStatistics& quads = report.quads;
  if (quads.count == 0) return nullptr;
  return {{"fraction", quads.fraction},
          {"min_scaled_jacobian", quads.min_jacobian},
          {"mean_scaled_jacobian", quads.mean_jacobian},
          {"min_scaled_jacobian_in_space", quads.min_space_jacobian},
          {"mean_scaled_jacobian_in_space", quads.mean_space_jacobian},
          {"inverted", quads.inverted},
          {"below_0.1", quads.flat},
          {"folded_in_space", quads.folded},
          {"irregular_vertices", quads.irregular_share},
          {"histogram", detail::histogram_json(quads.histogram)},
          {"worst", worst_json(report.worst_quad)},
          {"worst_in_space", worst_json(report.worst_quad_in_space)}};
}

/// True for the stages that ask for the metric.
bool is_asking(Stage stage) { return is_meshing(stage) && stage != Stage::Assemble; }

/// Null where nothing was searched by walks, as in a lattice.
Json walk_json(const QueryCounts& answers) {
  if (answers.walks == 0) return nullptr;
  return {{"count", answers.walks},
          {"mean_steps", static_cast<double>(answers.steps) / static_cast<double>(answers.walks)}};
}

Json queries_json(const PerStage<QueryCounts>& queries) {
  Json json = Json::object();
  for (const Stage stage : kStages) {
    if (is_asking(stage)) json[std::string(name(stage))] = queries[stage].total();
  }
  return json;
}

Json answers_json(const QueryCounts& answers) {
  return {{"s", answers.single},      {"t", answers.triangle},      {"o", answers.circles},
          {"linear", answers.linear}, {"lattice", answers.lattice}, {"extended", answers.extended},
          {"reused", answers.reused}};
}

/// Null where nothing was measured.
Json precision_json(const PrecisionSample& sample) {
  if (sample.points == 0) return nullptr;
  return {{"asked", sample.asked},
          {"greatest_miss", sample.greatest},
          {"share_over", sample.share_over()},
          {"greatest_miss_in_short_cells", sample.greatest_in_short_cells},
          {"over_in_short_cells", sample.over_in_short_cells},
          {"points", sample.points}};
}

Json control_json(const Report::Control& control) {
  return {{"kind", to_text(ranges::kControl, static_cast<double>(control.kind))},
          {"nodes", control.nodes},
          {"faces", control.faces},
          {"precision", precision_json(control.precision)},
          {"classes",
           {{"s", control.classes.single},
            {"t", control.classes.triangle},
            {"o", control.classes.circles},
            {"linear", control.classes.linear}}},
          {"queries", queries_json(control.queries)},
          {"answers", answers_json(control.queries.sum())},
          {"walks", walk_json(control.queries.sum())}};
}

Json seconds_json(const Report& report) {
  Json json = Json::object();
  for (const Stage stage : kStages) json[std::string(name(stage))] = report.seconds[stage];
  json["total"] = report.seconds.sum();
  json["serial"] = report.serial_seconds;
  json["wall"] = report.wall_seconds;
  return json;
}

/// Null in the report of an estimate, which has no mesh.
constexpr std::array<const char*, 12> kFiguresOfMesh = {"mesh",
                                                        "patches",
                                                        "groups",
                                                        "edge_lengths",
                                                        "edges",
                                                        "quality",
                                                        "quads",
                                                        "refine",
                                                        "diagonal",
                                                        "tolerance",
                                                        "triangles_per_second",
                                                        "triangles_per_second_in_all"};

}  // namespace

double Report::Pieces::largest_share() const {
  const double all = std::accumulate(faces_of_ranks.begin(), faces_of_ranks.end(), 0.0);
  if (all == 0) return 1;
  const std::size_t most = *std::max_element(faces_of_ranks.begin(), faces_of_ranks.end());
  return static_cast<double>(most * faces_of_ranks.size()) / all;
}

double Report::triangles_per_second() const {
  const double meshing = seconds.sum(is_meshing);
  return meshing > 0 ? static_cast<double>(mesh.triangles + mesh.quads) / meshing : 0;
}

double Report::triangles_per_second_in_all() const {
  const double total = seconds.sum();
  return total > 0 ? static_cast<double>(mesh.triangles + mesh.quads) / total : 0;
}

std::string to_json(const Report& report) try {
  Json json = {
      {"version", SURFMESH_VERSION},
      {"input", report.input},
      {"output", report.output.empty() ? Json(nullptr) : Json(report.output)},
      {"files", files_json(report.files)},
      {"given", given_json(report.given)},
      {"options", options_json(report.options)},
      {"notices", notices_json(report)},
      {"estimated_elements", std::round(report.estimated_elements)},
      {"mesh", mesh_json(report.mesh)},
      {"tiles", tiles_json(report.tiles)},
      {"pieces", pieces_json(report.pieces)},
      {"patches", patches_json(report.patches)},
      {"groups", groups_json(report.patches)},
      {"surfaces", surfaces_json(report.surfaces)},
      {"diagonal", report.diagonal},
      {"tolerance", report.tolerance},
      {"edge_lengths",
       {{"min", report.lengths.min}, {"mean", report.lengths.mean}, {"max", report.lengths.max}}},
      {"edges", detail::edges_json(report.edges)},
      {"quality", quality_json(report)},
      {"quads", quads_json(report)},
      {"sag",
       {{"asked", or_null(report.sag.asked)},
        {"reached", or_null(report.sag.reached)},
        {"evaluations", or_null(report.sag.evaluations)}}},
      {"facets", report.facets ? detail::facets_json(*report.facets) : Json(nullptr)},
      {"refine",
       {{"inserted", report.refine.inserted},
        {"left_too_large", report.refine.refused},
        {"circumcentres_given_up", report.refine.unconforming}}},
      {"control", control_json(report.control)},
      {"seconds", seconds_json(report)},
      {"triangles_per_second", report.triangles_per_second()},
      {"triangles_per_second_in_all", report.triangles_per_second_in_all()}};
  if (report.mesh.vertices == 0) {
    for (const char* figure : kFiguresOfMesh) json[figure] = nullptr;
  }
  // Names in models need not be UTF-8: what is not becomes a replacement character.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing a report");
}

}  // namespace surfmesh
