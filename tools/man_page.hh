// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// The manual page of the program or of one of its commands, in the language of man(7): what its
/// help has, with all options, their ranges and defaults.
std::string man_page(const CLI::App& app);

}  // namespace surfmesh
