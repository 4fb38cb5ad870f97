// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/comparison.hh"
#include "compare/peers.hh"
#include "compare/remesh_comparison.hh"
#include "pictures/machine.hh"

namespace surfmesh::compare {

/// Everything that a comparison has found.
struct Comparison {
  Machine machine;
  std::string surfmesh_version;
  std::vector<Peer> peers;  ///< with those that were not found
  int rounds = 0;
  double time_limit = 0;
  std::vector<CaseResult> cases;
  std::vector<RemeshResult> remeshing = {};
};

/// The whole in Markdown: the machine, the tools, a table for each case, the commands.
std::string markdown(const Comparison& comparison);

/// The table of one case in Markdown, a row for each tool. Ratios are to the first.
std::string case_table(const CaseResult& result);

/// The same numbers as JSON.
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace surfmesh::compare
