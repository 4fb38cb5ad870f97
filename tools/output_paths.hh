// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace surfmesh {

/// Throws   Io where no file of this path can be written: it is a folder, or there is none for it
void check_writable(const std::filesystem::path& path);

/// True if both paths lead to one file, which need not exist.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace surfmesh
