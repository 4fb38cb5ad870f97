// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {

/// Options of the pipeline by name, in the order of their effect.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Try a setting on options of its own: the fault of a command line is told before any work.
/// Returns the reason, empty if there is none.
std::string fault_of(const std::string& name, const std::string& value);

/// What the short help of a command shows of its flags.
enum class ShortHelp { MostUsed, None };

/// Add a flag for each option of these groups, `--max-elements` for `max_elements`; the short help
/// shows those that are most used, or none, --help-all every one with its range. A switch without a
/// value is on. Returns the flags.
std::vector<CLI::Option*> add_flags(CLI::App& command, Settings& settings,
                                    std::span<const OptionGroup> groups,
                                    ShortHelp short_help = ShortHelp::MostUsed);

/// Leave a flag out of the short help of a command to which flags were added; --help-all shows it.
void hide_in_short_help(CLI::App& command, const CLI::Option* flag);

/// Have a flag in it after all.
void show_in_short_help(CLI::App& command, const CLI::Option* flag);

/// The option of the table that a flag sets, null for other flags.
const Option* table_option(const CLI::Option& flag);

/// What a flag is, in one line, with unit and range: as --help-all has it.
std::string long_text(const CLI::Option& flag);

/// True for flags that have a value, and are on without one.
bool may_stand_alone(const CLI::Option& flag);

/// Add -v, --verbose to a command, with its text in the help.
void add_verbose(CLI::App& command, bool& is_verbose, const std::string& text);

/// The arguments of a command line, with "=on" at switches, and at lengths that may be on, before
/// an option, a file or nothing.
std::vector<std::string> with_switch_values(std::vector<std::string> arguments);

/// What the command line asks for that a cage has to be loaded with.
LoadOptions load_options(Scheme scheme, const Settings& settings);

/// Add --scheme to a command.
void add_scheme(CLI::App& command, Scheme& scheme);

/// Add --set to a command, with its text in the help.
void add_set(CLI::App& command, Settings& settings, const std::string& text);

}  // namespace surfmesh
