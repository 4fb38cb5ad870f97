// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/dissolved_contours.hh"

#include <cstddef>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/model/surface_walk.hh"

namespace surfmesh {

std::vector<char> dissolved_contours(const Model& model) {
  std::vector<char> is_dissolved = smooth_contours(model, orient_patches(model).cut_contours);
  const auto groups = groups_by_patch(mesh_names(model), model.patches.size());
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (is_dissolved[c] == 0) continue;
    const auto first = static_cast<std::size_t>(contour.uses[0].patch);
    const auto second = static_cast<std::size_t>(contour.uses[1].patch);
    if (contour.is_named || groups[first] != groups[second]) is_dissolved[c] = 0;
  }
  return is_dissolved;
}

}  // namespace surfmesh
