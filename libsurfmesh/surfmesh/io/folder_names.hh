// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace surfmesh {

/// The names of what is in a folder, in no order. The iterator of the standard library ends the
/// program where memory runs out (libstdc++ 12).
///
/// Throws   Io if it cannot be read
std::vector<std::string> folder_names(const std::filesystem::path& folder);

}  // namespace surfmesh
