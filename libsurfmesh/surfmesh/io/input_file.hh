// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Read a whole file into memory.
///
/// Throws   Io, naming the file and the reason (it does not exist, is a folder, ...)
std::string read_file(const std::filesystem::path& path);

/// The ending of a path in lower case, with its dot: ".obj"; empty if there is none.
std::string lower_case_ending(const std::filesystem::path& path);

}  // namespace surfmesh
