// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Write a mesh in OpenMesh's own format, with all its persistent properties.
/// Throws   Io
void write_om(const PolyMesh& mesh, OutputFile& file);

/// Read a mesh from the bytes of an .om file; `name` stands in messages.
/// Throws   InvalidInput
PolyMesh parse_om(std::string bytes, const std::string& name);

}  // namespace surfmesh
