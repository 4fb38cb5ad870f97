// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/remesh_comparison.hh"

namespace surfmesh::compare {

/// The table of one input in Markdown, a row for the input and one for each mesh of it, and the
/// aims that were missed.
std::string remesh_table(const RemeshResult& result);

/// The section of the comparison, with how to read it; empty without results.
std::string remesh_section(const std::vector<RemeshResult>& results);

/// The command of every row.
std::string remesh_commands(const std::vector<RemeshResult>& results);

nlohmann::ordered_json to_json(const RemeshResult& result);

}  // namespace surfmesh::compare
