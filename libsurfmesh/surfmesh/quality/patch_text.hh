// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh::detail {

/// " of patch wing" for a face, by the number where the patch has no name; nothing where the face
/// has no patch.
inline std::string patch_text(const MeshArrays& set, std::size_t face) {
  if (face >= set.patches.size() || set.patches[face] < 0) return {};
  const auto patch = static_cast<std::size_t>(set.patches[face]);
  const auto& names = set.names.patches;
  if (patch >= names.size()) return fmt::format(" of patch {}", patch);
  return fmt::format(" of patch {}", names[patch]);
}

}  // namespace surfmesh::detail
