// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>

namespace surfmesh {

/// Throws   Io where no file of this path can be written: it is a folder, or there is none for it
void check_writable(const std::filesystem::path& path);

/// Throws   Io if `output` is one of the files that are read
void check_not_overwritten(std::span<const std::filesystem::path> inputs,
                           const std::filesystem::path& output);

/// True if both paths lead to one file, which need not exist.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace surfmesh
