// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/report.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <variant>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/pipeline/notice_json.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

using Json = nlohmann::ordered_json;

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

Json edges_json(const EdgeStatistics& edges) {
  Json histogram = Json::array();
  for (const HistogramBin& bin : edges.histogram) {
    histogram.push_back({{"from", bin.from}, {"to", bin.to}, {"count", bin.count}});
  }
  return {{"count", edges.count},  {"mean", edges.mean}, {"stddev", edges.stddev},
          {"min", edges.min},      {"max", edges.max},   {"unit_fraction", edges.unit_fraction},
          {"histogram", histogram}};
}

/// Null without triangles, as quads_json is without quads.
Json quality_json(const Report& report) {
  if (report.quality.count == 0) return nullptr;
  return {{"min", report.quality.min},
          {"mean", report.quality.mean},
          {"below_0.3", report.quality.below_0_3},
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
  json["wall"] = report.wall_seconds;
  return json;
}

std::string histogram_share(const EdgeStatistics& edges) {
  return fmt::format("{:.1f} % in [1/√2, √2]", 100 * edges.unit_fraction);
}

std::string place_text(const std::optional<Report::WorstFace>& worst) {
  return worst ? fmt::format(" in patch {} at {}", worst->patch, point_text(worst->point)) : "";
}

/// The faces of a mesh: "12 quads, 1 triangle".
std::string faces_text(const Report::Mesh& mesh) {
  if (mesh.quads == 0) return counted(mesh.triangles, "triangle", "triangles");
  const std::string quads = counted(mesh.quads, "quad", "quads");
  if (mesh.triangles == 0) return quads;
  return fmt::format("{}, {}", quads, counted(mesh.triangles, "triangle", "triangles"));
}

std::string irregular_text(const QuadStatistics& quads) {
  if (quads.count == 0) return "";
  return fmt::format("; {:.1f} % of the inner vertices irregular", 100 * quads.irregular_share);
}

/// Makes the lines of a text for a terminal.
class Lines {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += fmt::format("{:<9}{}\n", key, value);
  }

  void add_control(const Report::Control& control) {
    add("control", fmt::format("{}, {} nodes, {} faces",
                               to_text(ranges::kControl, static_cast<double>(control.kind)),
                               control.nodes, control.faces));
  }

  void add_edges(const Report& report) {
    const Report::Lengths& lengths = report.lengths;
    add("edges", fmt::format("{:.4g} to {:.4g} long, mean {:.4g}; the model's diagonal is {:.4g}",
                             lengths.min, lengths.max, lengths.mean, report.diagonal));
    add("",
        fmt::format("metric length (1 is wanted): mean {:.3f}, deviation {:.3f}, from {:.3f} to "
                    "{:.3f}, {}",
                    report.edges.mean, report.edges.stddev, report.edges.min, report.edges.max,
                    histogram_share(report.edges)));
  }

  /// Of triangles, of quads, or of both.
  void add_quality(const Report& report) {
    const QualityStatistics& quality = report.quality;
    if (quality.count > 0) {
      add("quality", fmt::format("mean {:.3f}, {:.2f} % below 0.3, least {:.3f}{}", quality.mean,
                                 100 * quality.below_0_3, quality.min, place_text(report.worst)));
    }
    const QuadStatistics& quads = report.quads;
    if (quads.count == 0) return;
    add("quads",
        fmt::format("scaled Jacobian in the metric: mean {:.3f}, least {:.3f}{}",
                    quads.mean_jacobian, quads.min_jacobian, place_text(report.worst_quad)));
    add("", fmt::format("in space: mean {:.3f}, least {:.3f}{}", quads.mean_space_jacobian,
                        quads.min_space_jacobian, place_text(report.worst_quad_in_space)));
  }

  void add_time(const Report& report) {
    add("time", fmt::format("{:.2f} s of processor, {:.2f} s by the clock", report.seconds.sum(),
                            report.wall_seconds));
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

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

double Report::triangles_per_second() const {
  const double meshing = seconds.sum(is_meshing);
  return meshing > 0 ? static_cast<double>(mesh.triangles + mesh.quads) / meshing : 0;
}

double Report::triangles_per_second_in_all() const {
  const double total = seconds.sum();
  return total > 0 ? static_cast<double>(mesh.triangles + mesh.quads) / total : 0;
}

std::string to_json(const Report& report) {
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
      {"patches", patches_json(report.patches)},
      {"groups", groups_json(report.patches)},
      {"diagonal", report.diagonal},
      {"tolerance", report.tolerance},
      {"edge_lengths",
       {{"min", report.lengths.min}, {"mean", report.lengths.mean}, {"max", report.lengths.max}}},
      {"edges", edges_json(report.edges)},
      {"quality", quality_json(report)},
      {"quads", quads_json(report)},
      {"sag",
       {{"asked", or_null(report.sag.asked)},
        {"reached", or_null(report.sag.reached)},
        {"evaluations", or_null(report.sag.evaluations)}}},
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
}

std::string estimate_text(const Report& report) {
  Lines lines;
  lines.add("input", report.input);
  lines.add("estimate", fmt::format("about {:.3g} {}, {}", report.estimated_elements,
                                    report.options.quads.is_on ? "quads" : "triangles",
                                    counted(report.mesh.patches, "patch", "patches")));
  if (report.options.sizing.sag) {
    lines.add("", "the sag changes sizes where a first mesh shows it, and so the number");
  }
  lines.add_control(report.control);
  lines.add_time(report);
  lines.add("notices", fmt::format("{}", report.notices.size()));
  return lines.take();
}

std::string to_text(const Report& report) {
  const Report::Mesh& mesh = report.mesh;
  Lines lines;
  lines.add("input", report.input);
  if (!report.output.empty()) lines.add("output", report.output);
  lines.add("mesh", fmt::format("{} vertices, {}, {}", mesh.vertices, faces_text(mesh),
                                counted(mesh.patches, "patch", "patches")));
  lines.add("", fmt::format("{}, Euler characteristic {}{}", mesh.is_closed ? "closed" : "open",
                            mesh.euler, irregular_text(report.quads)));
  lines.add_edges(report);
  lines.add_quality(report);
  if (report.sag.asked && report.sag.reached) {
    lines.add("sag", fmt::format("{:.4g} reached, {:.4g} asked for", *report.sag.reached,
                                 *report.sag.asked));
  }
  lines.add_control(report.control);
  lines.add_time(report);
  lines.add("", fmt::format("{:.0f} {} a second in all, {:.0f} without control space and files",
                            report.triangles_per_second_in_all(),
                            mesh.quads > 0 ? "quads" : "triangles", report.triangles_per_second()));
  lines.add("notices", fmt::format("{}", report.notices.size()));
  return lines.take();
}

}  // namespace surfmesh
