// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/plane_judge.hh"

namespace surfmesh::compare {

/// What was measured of one tool in one case. Each number is of one round, in their order.
struct ToolResult {
  std::string tool;
  std::string command;
  std::string failure;  ///< why there is no mesh; empty if there is one
  std::string remark;   ///< what else to know of the mesh
  Judgement mesh;  ///< of the last round; for cages its lengths are not set, qualities in space
  double distance = 0;  ///< greatest, from the surface, share of the diagonal; only for cages
  std::vector<double> processor_seconds;  ///< of the whole process
  std::vector<double> clock_seconds;      ///< of the same
  std::vector<double> meshing_seconds;    ///< as the tool itself tells; empty if it does not
};

/// One input that every tool has meshed; surfmesh is the first.
struct CaseResult {
  std::string name;
  std::string about;  ///< one sentence
  bool is_cage = false;
  std::vector<ToolResult> tools;
};

/// The middle of three numbers, of a ratio over the rounds: "0.30 [0.29, 0.33]".
struct Spread {
  double median = 0;
  double least = 0;
  double greatest = 0;

  friend bool operator==(const Spread&, const Spread&) = default;
};

/// Round by round, how many times the seconds of `of` are those of `to`; nothing if there are none.
std::optional<Spread> ratio(const std::vector<double>& of, const std::vector<double>& to);

/// Triangles per processor second; nothing without seconds, or if they are below the resolution.
std::optional<double> speed(std::size_t triangles, const std::vector<double>& seconds);

/// How the comparison is run.
struct Settings {
  std::filesystem::path source;  ///< the directory of the repository
  std::filesystem::path work;    ///< for inputs and outputs of the tools
  std::filesystem::path surfmesh;
  int rounds = 3;
  bool is_quick = false;    ///< leave out what takes long
  double time_limit = 120;  ///< seconds by the clock, of one run
  std::function<void(const std::string&)> tell = [](const std::string&) {};  ///< progress
};

}  // namespace surfmesh::compare
