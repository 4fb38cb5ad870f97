// SPDX-License-Identifier: BSD-3-Clause
#include "compare/remesh_text.hh"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "compare/table_cells.hh"

namespace surfmesh::compare {
namespace {

constexpr const char* kHeadOfRemeshing =
    "| sizes | tool | faces | distance of faces, × input | of vertices, × input | of the surface "
    "| of features | Q least / mean | topology | seconds | by the clock | time to surfmesh |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n";

constexpr const char* kHowToReadRemeshing =
    "\nThe inputs are meshes of limit surfaces by surfmesh, with one size or (adaptive) sizes from "
    "curvature and triangles stretched up to twice, without patches. Each is "
    "remeshed with sides of half, the same and five times the mean length of its own, and by "
    "surfmesh and Mmgs with sizes from curvature. Edges of more than 40° are sharp for the other "
    "tools; surfmesh finds them itself. `pmp_remesh` and `cgal_remesh` are programs of your own "
    "that call the remeshing of pmp-library and of CGAL: `INPUT.off OUTPUT.off LENGTH ANGLE`, "
    "10 iterations, edges above ANGLE degrees are kept; `--version` prints the version.\n\n"
    "All meshes are judged by the same code, against the true limit surface: distances are mean / "
    "greatest, in % of the diagonal, and × input is the mean over that of the faces of the input. "
    "The vertices tell how far the surface of a tool is off; faces are off by their chords as "
    "well, and of the same length they cannot be nearer than the input's. Features: the greatest "
    "distance of creases and borders from the mesh. Crossings: pairs of faces that pass through "
    "each other; turned faces: by more than 120° from the surface, where they are near it. The "
    "aims are half of the input's distance, "
    "and a quarter on smooth surfaces from 30,000 triangles on: by the vertices at all sizes; "
    "half by the faces at half the length. Q = 4√3·A/Σl² in space, of quads as two triangles. "
    "Seconds are those of the processor, for the whole process.\n";

std::string tool_name(const RemeshRow& row) {
  return row.is_quads ? row.run.tool + ", quads" : row.run.tool;
}

std::string distance_text(const Distances& distances) {
  return fmt::format("{:.4f} / {:.3f}", 100 * distances.mean, 100 * distances.max);
}

/// A mean over that of the faces of the input.
std::string share_text(double mean, const RemeshJudgement& input) {
  return input.facets.mean > 0 ? fmt::format("{:.2f}", mean / input.facets.mean) : kNone;
}

std::string topology_text(const RemeshJudgement& mesh, const RemeshJudgement& input) {
  std::string text = mesh.has_topology_of(input) ? "same" : fmt::format("χ {}", mesh.euler);
  if (mesh.boundary_loops != input.boundary_loops) {
    text += fmt::format(", {} borders", mesh.boundary_loops);
  }
  if (!mesh.faults.empty() && mesh.faults != input.faults) text += ", " + mesh.faults;
  if (mesh.crossings > 0) text += fmt::format(", {} crossings", mesh.crossings);
  if (mesh.turned > 0) text += fmt::format(", {} turned", mesh.turned);
  return text;
}

std::string judgement_cells(const RemeshJudgement& mesh, const RemeshJudgement& input) {
  return fmt::format(
      "{} | {}, {} | {}, {} | {} | {:.3f} | {:.2f} / {:.3f} | {}", with_commas(mesh.faces),
      distance_text(mesh.facets), share_text(mesh.facets.mean, input), distance_text(mesh.vertices),
      share_text(mesh.vertices.mean, input), distance_text(mesh.from_surface), 100 * mesh.features,
      mesh.least_quality, mesh.mean_quality, topology_text(mesh, input));
}

std::string row_text(const RemeshRow& row, const RemeshResult& result, const RemeshRow& first) {
  const std::string head = fmt::format("| {} | {} | ", name(row.sizes), tool_name(row));
  if (!row.run.failure.empty()) {
    std::string line = head + row.run.failure + " |";
    constexpr int kCellsAfter = 9;
    for (int i = 0; i < kCellsAfter; ++i) line += fmt::format(" {} |", kNone);
    return line + "\n";
  }
  return head +
         fmt::format("{} | {} | {} | {} |\n", judgement_cells(row.mesh, result.input),
                     seconds_text(row.run.processor_seconds), seconds_text(row.run.clock_seconds),
                     spread_text(ratio(row.run.processor_seconds, first.run.processor_seconds)));
}

nlohmann::ordered_json to_json(const Distances& distances) {
  return {{"mean", distances.mean}, {"max", distances.max}};
}

nlohmann::ordered_json to_json(const RemeshJudgement& mesh) {
  return {{"faces", mesh.faces},
          {"area", mesh.area},
          {"mean_edge", mesh.mean_edge},
          {"facets", to_json(mesh.facets)},
          {"vertices", to_json(mesh.vertices)},
          {"from_surface", to_json(mesh.from_surface)},
          {"features", mesh.features},
          {"quality", {{"min", mesh.least_quality}, {"mean", mesh.mean_quality}}},
          {"euler", mesh.euler},
          {"components", mesh.components},
          {"boundary_loops", mesh.boundary_loops},
          {"crossings", mesh.crossings},
          {"turned", mesh.turned},
          {"faults", mesh.faults}};
}

nlohmann::ordered_json to_json(const RemeshRow& row) {
  nlohmann::ordered_json json = {{"sizes", name(row.sizes)},
                                 {"tool", row.run.tool},
                                 {"quads", row.is_quads},
                                 {"command", row.run.command},
                                 {"processor_seconds", row.run.processor_seconds},
                                 {"clock_seconds", row.run.clock_seconds}};
  if (row.run.failure.empty()) {
    json["mesh"] = to_json(row.mesh);
  } else {
    json["failure"] = row.run.failure;
  }
  return json;
}

}  // namespace

std::string remesh_table(const RemeshResult& result) {
  std::string text = kHeadOfRemeshing;
  text +=
      fmt::format("| input | – | {} | – | – | – |\n", judgement_cells(result.input, result.input));
  const RemeshRow* first = nullptr;
  for (const RemeshRow& row : result.rows) {
    if (first == nullptr || row.sizes != first->sizes) first = &row;
    text += row_text(row, result, *first);
  }
  const auto missed = missed_aims(result);
  if (!missed.empty()) text += "\nMissed by surfmesh:\n\n";
  for (const std::string& aim : missed) text += fmt::format("- {}\n", aim);
  return text;
}

std::string remesh_section(const std::vector<RemeshResult>& results) {
  if (results.empty()) return "";
  std::string text = fmt::format("\n## Remeshing\n{}", kHowToReadRemeshing);
  for (const RemeshResult& result : results) {
    text += fmt::format("\n### {}: {}\n\n{}", result.name, result.about, remesh_table(result));
  }
  return text;
}

std::string remesh_commands(const std::vector<RemeshResult>& results) {
  std::string text;
  for (const RemeshResult& result : results) {
    text += fmt::format("\n{}:\n\n", result.name);
    for (const RemeshRow& row : result.rows) text += fmt::format("    {}\n", row.run.command);
  }
  return text;
}

nlohmann::ordered_json to_json(const RemeshResult& result) {
  nlohmann::ordered_json json = {{"name", result.name},
                                 {"about", result.about},
                                 {"smooth", result.is_smooth},
                                 {"wanted_share", wanted_share(result)},
                                 {"input", to_json(result.input)},
                                 {"meshes", nlohmann::ordered_json::array()},
                                 {"missed", missed_aims(result)}};
  for (const RemeshRow& row : result.rows) json["meshes"].push_back(to_json(row));
  return json;
}

}  // namespace surfmesh::compare
