// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// What a PLY file of a mesh holds.
struct PlyHead {
  const MeshNames* names = nullptr;  ///< of patches and groups; null for no patches
  std::span<const int> runs = {};    ///< the patches of all faces, if no values at them tell these
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t most_corners = 0;  ///< of a face
  bool has_patch_values = false;
};

/// The header of a PLY file in ASCII as we write it, up to `end_header`, without the end of its
/// line.
std::string ply_head(const PlyHead& head);

/// False for names with control characters, which become blanks.
bool can_be_in_ply(const std::string& name);

}  // namespace surfmesh
