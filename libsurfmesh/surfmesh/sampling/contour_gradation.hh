// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/make_control.hh"

namespace surfmesh {

/// What it took to make the control spaces of patches agree on their contours.
struct ContourGradationReport {
  std::size_t nodes = 0;   ///< that were added on contours
  std::size_t spaces = 0;  ///< control spaces that were made anew, each time
  bool has_converged = true;

  friend bool operator==(const ContourGradationReport&, const ContourGradationReport&) = default;
};

/// Let gradation go on from patch to patch: where a patch asks on a contour for larger sizes than
/// another patch there, it gets nodes with the minimum of both, and its sizes are graded from them;
/// until all agree to a twentieth, or forty rounds are over.
///
/// Sizes are carried across a contour as if the two tangent planes were unfolded around it.
/// Contours are compared at places two units apart at most. Nothing is done where gradation is off.
///
/// Cost     a metric query for each patch and place; a control space is made anew in each round in
///          which its sizes on some contour are lowered
/// Pre      inputs and spaces are those of the patches, in their order
/// Throws   Cancelled
ContourGradationReport grade_across_contours(const Model& model, std::vector<ControlInput>& inputs,
                                             std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                             const RunContext& context = RunContext());

}  // namespace surfmesh
