// SPDX-License-Identifier: BSD-3-Clause
#include "compare/report_text.hh"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/cage_comparison.hh"
#include "compare/remesh_text.hh"
#include "compare/table_cells.hh"

namespace surfmesh::compare {
namespace {

/// "43,100" for 43,123: three digits are all that a measured speed has.
std::string speed_text(std::optional<double> speed) {
  if (!speed) return kNone;
  double unit = 1;
  while (*speed >= 1000 * unit) unit *= 10;
  return with_commas(static_cast<std::size_t>(unit * (*speed / unit + 0.5)) / std::size_t(unit) *
                     std::size_t(unit));
}

std::string plane_cells(const Judgement& mesh) {
  return fmt::format("{} | {:.3f} | {:.3f} | {:.2f} % | {:.2f} / {:.3f}",
                     with_commas(mesh.triangles), mesh.mean, mesh.stddev, 100 * mesh.unit_fraction,
                     mesh.least_quality, mesh.mean_quality);
}

std::string cage_cells(const ToolResult& result) {
  return fmt::format("{} | {:.4f} % | {:.2f} / {:.3f}", with_commas(result.mesh.triangles),
                     100 * result.distance, result.mesh.least_quality, result.mesh.mean_quality);
}

std::string row(const ToolResult& result, const ToolResult& first, bool is_cage) {
  if (!result.failure.empty()) {
    std::string line = fmt::format("| {} | {} |", result.tool, result.failure);
    for (int i = 0; i < (is_cage ? 6 : 8); ++i) line += fmt::format(" {} |", kNone);
    return line + "\n";
  }
  const auto cells = is_cage ? cage_cells(result) : plane_cells(result.mesh);
  // Times of meshes that are farther away than asked for are not comparable.
  const bool is_comparable = !is_cage || result.distance <= kWantedSag;
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", result.tool, cells,
                     speed_text(speed(result.mesh.triangles, result.meshing_seconds)),
                     speed_text(speed(result.mesh.triangles, result.processor_seconds)),
                     seconds_text(result.processor_seconds),
                     is_comparable
                         ? spread_text(ratio(result.processor_seconds, first.processor_seconds))
                         : kNone);
}

std::string heading(const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  std::string text = fmt::format(
      "# surfmesh beside other meshers\n\n{}, {}, {} cores; load {:.1f} before, {:.1f} after. "
      "Medians of {} rounds, in each of which every tool ran once, with one thread.\n\nTools: "
      "surfmesh {}",
      machine.day, machine.processor, machine.cores, machine.load_before, machine.load_after,
      comparison.rounds, comparison.surfmesh_version);
  std::string absent;
  for (const Peer& peer : comparison.peers) {
    if (peer.program.empty()) {
      absent += fmt::format("{}{}", absent.empty() ? "" : ", ", peer.name);
    } else {
      text += fmt::format(", {} {}", peer.name, peer.version);
    }
  }
  return text + fmt::format(". Not found: {}.\n", absent.empty() ? "none" : absent);
}

constexpr const char* kHowToRead =
    "\nAll meshes of a plane case are judged by the same code, in the exact metric of the model: "
    "the length of an edge is ∫√(eᵀMe) along it (five points of Gauss), a unit edge has a length "
    "in [1/√2, √2], Q = 4√3·A/Σl² in the metric at the barycentre. The other tools get the metric "
    "at the nodes of a regular grid, whose making is not counted; reading it is, in the whole "
    "process. Meshing alone is what a tool tells itself (BAMG and Gmsh count their searches in the "
    "grid, surfmesh does not count its control space). A time is that of the processor, user and "
    "system; the last column is the time of the tool over that of surfmesh in the same round: "
    "median [least, greatest].\n";

constexpr const char* kHowToReadCages =
    "\nThe other tools remesh a mesh of the cage by surfmesh with a twentieth of the sag, whose "
    "making is not counted. Their option was sought in a few runs before, so that the distance is "
    "just below the wish; where no option reached it, the best one stands, without a comparison of "
    "times. Distance: the greatest from the surface, in % of the diagonal, by "
    "`surfmesh check` for all; Q is that in space.\n";

std::string commands(const Comparison& comparison) {
  std::string text = "\n## Commands\n";
  for (const CaseResult& result : comparison.cases) {
    text += fmt::format("\n{}:\n\n", result.name);
    for (const ToolResult& tool : result.tools) text += fmt::format("    {}\n", tool.command);
  }
  return text + remesh_commands(comparison.remeshing);
}

nlohmann::ordered_json to_json(const ToolResult& result, bool is_cage) {
  nlohmann::ordered_json json = {{"tool", result.tool}, {"command", result.command}};
  json["processor_seconds"] = result.processor_seconds;
  json["meshing_seconds"] = result.meshing_seconds;
  if (!result.failure.empty()) {
    json["failure"] = result.failure;
    return json;
  }
  json["remark"] = result.remark;
  json["triangles"] = result.mesh.triangles;
  json["quality"] = {{"min", result.mesh.least_quality}, {"mean", result.mesh.mean_quality}};
  if (is_cage) {
    json["distance"] = result.distance;
  } else {
    json["edges"] = {{"mean", result.mesh.mean},
                     {"stddev", result.mesh.stddev},
                     {"unit_fraction", result.mesh.unit_fraction}};
  }
  return json;
}

}  // namespace

std::string case_table(const CaseResult& result) {
  std::string text = result.is_cage
                         ? "| tool | triangles | distance | Q least / mean "
                         : "| tool | triangles | mean length | σ | unit edges | Q least / mean ";
  text += "| triangles/s, meshing | triangles/s, process | seconds | time to surfmesh |\n";
  text += result.is_cage ? "|---|---|---|---|---|---|---|---|\n"
                         : "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ToolResult& tool : result.tools) text += row(tool, result.tools[0], result.is_cage);
  for (const ToolResult& tool : result.tools) {
    if (!tool.remark.empty()) text += fmt::format("\n{}: {}\n", tool.tool, tool.remark);
  }
  return text;
}

std::string markdown(const Comparison& comparison) {
  std::string text = heading(comparison) + kHowToRead;
  bool is_told = false;
  for (const CaseResult& result : comparison.cases) {
    if (result.is_cage && !is_told) {
      text += fmt::format("\n## Cages by sag\n{}", kHowToReadCages);
      is_told = true;
    }
    text += fmt::format("\n{} {}: {}\n\n{}", result.is_cage ? "###" : "##", result.name,
                        result.about, case_table(result));
  }
  return text + remesh_section(comparison.remeshing) + commands(comparison);
}

nlohmann::ordered_json to_json(const Comparison& comparison) {
  const Machine& machine = comparison.machine;
  nlohmann::ordered_json json;
  json["machine"] = {{"day", machine.day},
                     {"processor", machine.processor},
                     {"cores", machine.cores},
                     {"load_before", machine.load_before},
                     {"load_after", machine.load_after}};
  json["rounds"] = comparison.rounds;
  json["time_limit"] = comparison.time_limit;
  json["surfmesh"] = comparison.surfmesh_version;
  json["peers"] = nlohmann::ordered_json::array();
  for (const Peer& peer : comparison.peers) {
    json["peers"].push_back({{"name", peer.name},
                             {"found", !peer.program.empty()},
                             {"program", peer.program.string()},
                             {"version", peer.version}});
  }
  json["cases"] = nlohmann::ordered_json::array();
  for (const CaseResult& result : comparison.cases) {
    nlohmann::ordered_json tools = nlohmann::ordered_json::array();
    for (const ToolResult& tool : result.tools) tools.push_back(to_json(tool, result.is_cage));
    json["cases"].push_back({{"name", result.name}, {"about", result.about}, {"tools", tools}});
  }
  json["remeshing"] = nlohmann::ordered_json::array();
  for (const RemeshResult& result : comparison.remeshing) {
    json["remeshing"].push_back(to_json(result));
  }
  return json;
}

}  // namespace surfmesh::compare
