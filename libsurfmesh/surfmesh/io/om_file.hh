// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Write a mesh in OpenMesh's own format, with all its persistent properties.
/// Throws   Io
void write_om(const PolyMesh& mesh, OutputFile& file);

}  // namespace surfmesh
