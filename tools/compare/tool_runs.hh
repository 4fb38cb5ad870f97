// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "compare/comparison.hh"
#include "compare/run_process.hh"

namespace surfmesh::compare {

/// How one tool meshes one case.
struct ToolTask {
  std::string tool;
  Command command;
  std::filesystem::path output;  ///< the mesh it writes, in the directory of the run
  /// Meshing seconds from its run; null if it does not tell them.
  std::function<std::optional<double>(const ProcessRun&)> told_seconds = nullptr;
};

/// The task of surfmesh, with more options; its report lies next to the output.
ToolTask surfmesh_task(const Settings& settings, const std::filesystem::path& model,
                       const std::filesystem::path& output, const Command& options);

/// Run each tool once in every round, in turn. One that fails is not run again.
///
/// What goes wrong, or has no mesh, is told in `failure`.
std::vector<ToolResult> run_in_turn(const Settings& settings, const std::string& name,
                                    const std::vector<ToolTask>& tasks);

/// Run a tool once: the failure in a few words, empty if there is a mesh.
std::string run_once(const Settings& settings, const ToolTask& task, ProcessRun& run);

}  // namespace surfmesh::compare
