// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/make_control.hh"

namespace surfmesh {

/// The work it took to make the control spaces of patches agree on their contours.
struct ContourGradationReport {
  std::size_t lowered = 0;  ///< nodes on contours that came down, or were added, counted each time
  std::size_t added = 0;    ///< nodes of cells that were halved at contours
  std::size_t spaces = 0;   ///< triangulations made anew, counted each time
  int rounds = 0;

  friend bool operator==(const ContourGradationReport&, const ContourGradationReport&) = default;
};

/// Continue gradation across contours, until all patches agree there.
///
/// Sizes are carried across a contour as if the two tangent planes were unfolded around it. Does
/// nothing if gradation is off.
///
/// Cost     of lattices, detail::grade_lattices_across_contours; of triangulations,
///          detail::grade_meshes_across_contours
/// Pre      inputs and spaces are those of the patches, in their order; all of one kind
/// Throws   Cancelled
ContourGradationReport grade_across_contours(const Model& model, std::vector<ControlInput>& inputs,
                                             std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                             const RunContext& context = RunContext());

}  // namespace surfmesh
