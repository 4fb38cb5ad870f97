// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The endings of the formats of meshes, as they stand in messages and in help: ".obj, .off or
/// .om".
std::string mesh_endings();

/// Those of control cages.
std::string cage_endings();

/// True if the ending is one of control cages, in upper or lower case.
bool has_cage_ending(const std::filesystem::path& path);

/// Throws   InvalidInput unless the ending is one that write_mesh and read_mesh know
void check_mesh_ending(const std::filesystem::path& path);

}  // namespace surfmesh
