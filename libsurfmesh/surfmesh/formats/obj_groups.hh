// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// The names of patches and of groups as words of an OBJ file: those of patches differ among each
/// other, and those of groups.
struct ObjWords {
  ObjWords(const MeshNames& names, std::size_t patch_count);

  std::vector<std::string> patches;
  std::vector<std::string> groups;
};

/// The lines by which an OBJ file tells the groups of faces, each with the end of the line before
/// it.
class ObjGroups {
 public:
  /// `patches` are those of all faces; each has to be there once.
  /// Throws   InvalidInput for a patch of which the number is too large for a file
  ObjGroups(std::span<const int> patches, const MeshNames& names);

  /// The lines in front of faces of a patch, -1 for none.
  std::string_view of_patch(int patch) const {
    return patch < 0 ? "\ng" : std::string_view(lines_[static_cast<std::size_t>(patch)]);
  }

  /// What stands before all faces: the lines of all patches, so that they keep their numbers,
  /// unless the faces have them in this order. `patches` are those of the faces; of faces in a row
  /// with the same patch one is enough.
  std::string before_faces(std::span<const int> patches) const;

 private:
  std::vector<std::string> lines_;  ///< by patch
};

}  // namespace surfmesh
