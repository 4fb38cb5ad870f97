// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// The same for zsh, which also shows what the options are. It works as a function of a folder in
/// $fpath and where it is sourced.
std::string zsh_completion(const CLI::App& program);

}  // namespace surfmesh
