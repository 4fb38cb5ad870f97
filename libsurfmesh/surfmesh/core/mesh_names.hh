// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A named set of patches: OBJ's `g`, `o` and `usemtl`, a cage of a model file.
struct Group {
  std::string name;
  std::vector<int> patches;  ///< ascending in MeshNames
  bool is_material = false;  ///< OBJ's `usemtl`, and written as such

  friend bool operator==(const Group&, const Group&) = default;
};

/// What the patches and contours of a mesh are called, and the groups of patches.
struct MeshNames {
  std::vector<std::string> patches;        ///< by patch; empty, or not there, for no name
  std::vector<Group> groups;               ///< a patch may be in any number of them
  std::vector<std::string> contours = {};  ///< by contour; empty, or not there, for no name

  friend bool operator==(const MeshNames&, const MeshNames&) = default;
};

/// Bring the groups in the order of their first patch, which is the order in which a file names
/// them, and the patches of each in their own, without repeats; drop groups without patches.
void put_in_order(std::vector<Group>& groups);

/// The groups that each of `count` patches is in, as indices, ascending.
std::vector<std::vector<int>> groups_by_patch(const MeshNames& names, std::size_t count);

}  // namespace surfmesh
