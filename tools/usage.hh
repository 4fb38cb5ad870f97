// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// What is wrong with a command line that could not be parsed, in one line: a misspelt option or
/// command with the one that was probably meant, else what the parser says.
std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

/// The command line that shows the help for what was asked: "surfmesh mesh --help".
std::string help_line(const CLI::App& app);

}  // namespace surfmesh
