// SPDX-License-Identifier: BSD-3-Clause
#include "compare/tool_runs.hh"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "exit_status.hh"

namespace surfmesh::compare {
namespace {

std::optional<double> seconds_of_report(const std::filesystem::path& path) {
  std::ifstream file(path);
  const auto report = nlohmann::json::parse(file, nullptr, false);
  if (!report.is_object()) return std::nullopt;
  const double speed = report.value("triangles_per_second", 0.0);
  const nlohmann::json mesh = report.value("mesh", nlohmann::json::object());
  const double triangles = mesh.is_object() ? mesh.value("triangles", 0.0) : 0;
  if (!(speed > 0) || !(triangles > 0)) return std::nullopt;
  return triangles / speed;
}

std::filesystem::path report_of(const std::filesystem::path& output) {
  std::filesystem::path path = output;
  return path.replace_extension(".report.json");
}

void add_round(const Settings& settings, const ToolTask& task, ToolResult& result) {
  ProcessRun run;
  result.failure = run_once(settings, task, run);
  if (!result.failure.empty()) return;
  result.processor_seconds.push_back(run.processor_seconds);
  result.clock_seconds.push_back(run.clock_seconds);
  if (!task.told_seconds) return;
  if (const auto seconds = task.told_seconds(run)) result.meshing_seconds.push_back(*seconds);
}

}  // namespace

ToolTask surfmesh_task(const Settings& settings, const std::filesystem::path& model,
                       const std::filesystem::path& output, const Command& options) {
  const std::filesystem::path report = report_of(output);
  ToolTask task{"surfmesh", {settings.surfmesh, "mesh", model, "-o", output}, output};
  task.command.insert(task.command.end(), options.begin(), options.end());
  for (const char* word : {"--report", report.c_str(), "--threads", "1", "--quiet"}) {
    task.command.push_back(word);
  }
  task.told_seconds = [path = settings.work / report](const ProcessRun&) {
    return seconds_of_report(path);
  };
  return task;
}

std::string run_once(const Settings& settings, const ToolTask& task, ProcessRun& run) {
  std::error_code error;
  std::filesystem::remove(settings.work / task.output,
                          error);  // one of an earlier round is no result
  run = run_process(task.command, settings.work, settings.time_limit);
  // A wish was not reached, but the mesh is there.
  if (task.tool == "surfmesh" && run.status == kFellShort) run.status = kDone;
  std::string failure = failure_of(run);
  if (failure.empty() && !std::filesystem::exists(settings.work / task.output))
    failure = "wrote no mesh";
  return failure;
}

std::vector<ToolResult> run_in_turn(const Settings& settings, const std::string& name,
                                    const std::vector<ToolTask>& tasks) {
  std::vector<ToolResult> results;
  for (const ToolTask& task : tasks) {
    results.push_back({});
    results.back().tool = task.tool;
    results.back().command = command_line(task.command);
  }
  for (int round = 0; round < settings.rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (!results[i].failure.empty()) continue;
      settings.tell(
          fmt::format("{}: round {} of {}, {}", name, round + 1, settings.rounds, tasks[i].tool));
      add_round(settings, tasks[i], results[i]);
      if (!results[i].failure.empty()) settings.tell("  " + results[i].failure);
    }
  }
  return results;
}

}  // namespace surfmesh::compare
