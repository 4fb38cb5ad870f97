// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/mesh_names.hh"

#include <algorithm>

namespace surfmesh {

void put_in_order(std::vector<Group>& groups) {
  for (Group& group : groups) {
    std::sort(group.patches.begin(), group.patches.end());
    group.patches.erase(std::unique(group.patches.begin(), group.patches.end()),
                        group.patches.end());
  }
  std::erase_if(groups, [](const Group& group) { return group.patches.empty(); });
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.patches.front() < b.patches.front();
  });
}

std::vector<std::vector<int>> groups_by_patch(const MeshNames& names, std::size_t count) {
  std::vector<std::vector<int>> groups(count);
  for (std::size_t g = 0; g < names.groups.size(); ++g) {
    for (const int patch : names.groups[g].patches) {
      if (patch < 0 || static_cast<std::size_t>(patch) >= count) continue;
      groups[static_cast<std::size_t>(patch)].push_back(static_cast<int>(g));
    }
  }
  return groups;
}

}  // namespace surfmesh
