// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace surfmesh {

/// How the value of an option is given.
enum class ValueUse { None, Needed, MayStandAlone };

/// What completion and manual pages tell of an option or a place of a command line, all of it from
/// the definition that is parsed by, and from the texts of its help.
struct OptionFacts {
  std::vector<std::string> names;  ///< "-o", "--output"; of a place, "INPUT"
  ValueUse use = ValueUse::None;
  std::string placeholder;           ///< stands for the value in help: "off|NUMBER", "FILE"
  std::string default_value;         ///< empty for none
  std::vector<std::string> choices;  ///< words that may be its value
  bool has_files = false;            ///< the value is the path of a file
  bool has_folders = false;          ///< of a folder
  std::vector<std::string> endings;  ///< of such files, without their dots; empty for any
  std::string text;                  ///< with unit and range, in one line
  std::string group;                 ///< its heading in the help
  std::vector<std::string> needs;    ///< other options without which it has no meaning
  bool is_required = false;
};

/// The options of a command, with the program's own if it is that.
std::vector<OptionFacts> option_facts(const CLI::App& command);

/// The places of a command, in their order: what stands there without a name.
std::vector<OptionFacts> place_facts(const CLI::App& command);

/// The commands of the program, in the order of its help.
std::vector<const CLI::App*> commands_of(const CLI::App& program);

/// The command of this name, null if there is none.
const CLI::App* find_command(const CLI::App& program, const std::string& name);

}  // namespace surfmesh
