// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_model.hh"

namespace surfmesh {

/// Options of the pipeline by name, in the order of their effect.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Try a setting on options of its own: the fault of a command line is told before any work.
/// Returns the reason, empty if there is none.
std::string fault_of(const std::string& name, const std::string& value);

/// Which options of the pipeline get flags of their own: those of the sizes, of the control space
/// and of cages, or those of the meshing, too.
enum class FlagSet { Control, Meshing };

/// Add flags for the options that are most used, in groups.
void add_flags(CLI::App& command, Settings& settings, FlagSet flags);

/// What the command line asks for that a cage has to be loaded with.
CageOptions cage_options(Scheme scheme, const Settings& settings);

/// The names of all options, for the help of --set.
std::string names_for_set();

/// Add --scheme to a command.
void add_scheme(CLI::App& command, Scheme& scheme);

/// Add --set to a command, with its text in the help.
void add_set(CLI::App& command, Settings& settings, const std::string& text);

}  // namespace surfmesh
