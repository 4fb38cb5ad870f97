// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Read the bytes of a PLY file, see read_face_set; `name` stands in messages.
/// Throws   InvalidInput
FaceSetFile parse_ply(std::string_view bytes, const std::string& name);

/// Write a binary little-endian PLY file: positions as doubles, surf:patch as the int property
/// `patch` of faces, the names of patches as comments.
/// Throws   Io; Geometry for a position that is not finite
void write_ply(const PolyMesh& mesh, const std::vector<std::string>& patch_names, OutputFile& file);

}  // namespace surfmesh
