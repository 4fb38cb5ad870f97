// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// STL: see read_mesh.hh and write_mesh.hh.
MeshFormat stl_format();

/// Read the bytes of an STL file, see read_mesh_arrays; `name` stands in messages.
/// Throws   InvalidInput
MeshArraysFile parse_stl(std::string_view bytes, const std::string& name);

}  // namespace surfmesh
