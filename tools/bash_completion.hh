// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// A script by which bash completes the command lines of a program: commands, options, choices, and
/// files of the endings that fit.
std::string bash_completion(const CLI::App& program);

}  // namespace surfmesh
