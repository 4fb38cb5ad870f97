// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/model_sources.hh"

namespace surfmesh {

std::vector<PatchSources> model_sources(const Model& model, const Sources& sources,
                                        const Sizing& sizing) {
  std::vector<PatchSources> result;
  const auto near = near_tree(sources, sizing, model.diagonal);
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    result.push_back(sources_of_patch(sources, static_cast<int>(p)));
    if (near) result.back().trees.push_back(near);
  }
  return result;
}

}  // namespace surfmesh
