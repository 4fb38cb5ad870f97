// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace surfmesh {

/// What is wrong with a command line that could not be parsed, in one line: a misspelt option or
/// command with the one that was probably meant, else what the parser says.
std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

/// What is wrong with arguments of one dash and several letters, "-hmax": the parser would take
/// them for -h and show the help. Empty if there is none; -o may have its file right behind it.
std::string one_dash_fault(const CLI::App& app, const std::vector<std::string>& arguments);

/// What is wrong with the command, which comes first: it is not known, whatever follows. Empty if
/// nothing is, or there is none.
std::string command_fault(const CLI::App& app, const std::vector<std::string>& arguments);

/// The command line that shows the help for what was asked: "surfmesh mesh --help".
std::string help_line(const CLI::App& app);

}  // namespace surfmesh
