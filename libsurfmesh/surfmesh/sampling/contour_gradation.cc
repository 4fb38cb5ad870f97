// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/contour_gradation.hh"

#include <algorithm>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/sampling/lattice_contour_gradation.hh"
#include "surfmesh/sampling/mesh_contour_gradation.hh"

namespace surfmesh {

ContourGradationReport grade_across_contours(const Model& model, std::vector<ControlInput>& inputs,
                                             std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                             const RunContext& context) {
  const bool is_off = std::all_of(inputs.begin(), inputs.end(), [](const ControlInput& input) {
    return input.options.grade == 0;
  });
  if (is_off) return {};
  const LeftOutOfSerial not_serial;  // each round needs the sizes of the one before
  if (inputs.front().kind == ControlKind::Mesh) {
    return detail::grade_meshes_across_contours(model, inputs, spaces, context);
  }
  return detail::grade_lattices_across_contours(model, spaces, context);
}

}  // namespace surfmesh
