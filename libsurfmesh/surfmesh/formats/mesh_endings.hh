// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The endings of all mesh formats, as messages and the help show them: ".obj, .off or .om".
std::string mesh_endings();

/// The endings of those that are read: some are only written.
std::string readable_mesh_endings();

/// The endings of control cages.
std::string cage_endings();

/// The endings of formats that hold normals and parameters of corners.
std::string corner_value_endings();

/// True if the ending is that of a mesh format, in upper or lower case.
bool has_mesh_ending(const std::filesystem::path& path);

/// True if the ending is that of a control cage, in upper or lower case.
bool has_cage_ending(const std::filesystem::path& path);

/// Throws   InvalidInput unless the ending is one that write_mesh knows
void check_mesh_ending(const std::filesystem::path& path);

/// Throws   InvalidInput unless the ending is one that read_mesh knows
void check_readable_ending(const std::filesystem::path& path);

}  // namespace surfmesh
