// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/geometry/cage.hh"

namespace surfmesh {

/// Options of the pipeline by name, in the order of their effect.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Try a setting on options of its own: the fault of a command line is told before any work.
/// Returns the reason, empty if there is none.
std::string fault_of(const std::string& name, const std::string& value);

/// Add --scheme to a command.
void add_scheme(CLI::App& command, Scheme& scheme);

/// Add --set to a command, with its text in the help.
void add_set(CLI::App& command, Settings& settings, const std::string& text);

}  // namespace surfmesh
