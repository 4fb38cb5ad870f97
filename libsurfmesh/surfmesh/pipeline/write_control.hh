// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// The control mesh of one patch, for writing. The mesh and the surface must outlive it.
struct ControlPicture {
  std::string patch;
  const PolyMesh* mesh;
  const Surface* surface;
};

/// Throws   InvalidInput, naming the file, unless its ending is .vtu or .obj
void check_control_ending(const std::filesystem::path& path);

/// Write the control meshes of patches on their surfaces, completely or not at all. The ending
/// selects the format.
///
/// .vtu, for ParaView: points have uv, the two sizes, the size tensor in space (symmetric, with
/// eigenvectors tangent to the surface), radius and outer radius; triangles have the patch and the
/// class of interpolation (0 V_s, 1 V_t, 2 V_o, 4 linear, -1 a cell of a grid). .obj: triangles
/// with their patches, as write_mesh.
///
/// Reads    surf:uv, surf:size; surf:radius, surf:outer_radius and surf:class if present
/// Cost     about 2 µs and 200 bytes per node
/// Throws   Io; Geometry for a position that is not finite; MissingProperty
void write_control(const std::vector<ControlPicture>& pictures, const std::filesystem::path& path);

/// The same to a file that is not finished yet.
void write_control(const std::vector<ControlPicture>& pictures, OutputFile& file);

}  // namespace surfmesh
