// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// PLY: see read_mesh.hh and write_mesh.hh.
MeshFormat ply_format();

/// Read the bytes of a PLY file, see read_mesh_arrays; `name` stands in messages.
/// Throws   InvalidInput
MeshArraysFile parse_ply(std::string_view bytes, const std::string& name);

}  // namespace surfmesh
