// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Read the bytes of an STL file, see read_face_set; `name` stands in messages.
/// Throws   InvalidInput
FaceSetFile parse_stl(std::string_view bytes, const std::string& name);

/// Write a binary STL file, with positions in single precision. Faces of more than three corners
/// are split: quads at their shorter diagonal, others into the fan of their first corner.
/// Throws   Io; Geometry for a position that is not finite, or not in single precision
void write_stl(const PolyMesh& mesh, OutputFile& file);

}  // namespace surfmesh
