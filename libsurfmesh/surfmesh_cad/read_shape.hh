// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh_cad/cad_shape.hh"

namespace surfmesh {

/// Read the shape of a file, with the names and colours of its parts.
///
/// Throws   as read_cad
CadShape read_shape(const std::filesystem::path& path);

}  // namespace surfmesh
