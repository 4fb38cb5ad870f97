// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// OpenMesh's own format, with all persistent properties and the names of patches and groups.
MeshFormat om_format();

/// Read a mesh from the bytes of an .om file; `name` stands in messages.
/// Throws   InvalidInput
MeshFile parse_om(std::string bytes, const std::string& name);

}  // namespace surfmesh
