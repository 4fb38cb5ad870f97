// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace surfmesh {

/// Parse the command line of a program and call `run()`, which does what it says.
/// Returns  the exit status of that, or of a command line that asks for help or is wrong
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace surfmesh
