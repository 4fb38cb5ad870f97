// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/model_parts.hh"

#include <cstddef>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/model/finish_model.hh"

namespace surfmesh {

std::vector<double> part_diagonals(const Model& model) {
  DisjointSets parts(model.patches.size());
  for (const Contour& contour : model.contours) {
    for (const ContourUse& use : contour.uses) {
      parts.unite(static_cast<std::size_t>(contour.uses.front().patch),
                  static_cast<std::size_t>(use.patch));
    }
  }
  std::vector<Eigen::AlignedBox3d> boxes(model.patches.size());
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    boxes[parts.find(p)].extend(sampled_box(*model.patches[p].surface));
  }
  std::vector<double> diagonals;
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    diagonals.push_back(boxes[parts.find(p)].diagonal().norm());
  }
  return diagonals;
}

}  // namespace surfmesh
