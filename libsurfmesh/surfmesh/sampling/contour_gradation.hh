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
  std::size_t nodes = 0;   ///< added on contours
  std::size_t spaces = 0;  ///< control spaces made anew, counted each time
  bool has_converged = true;

  friend bool operator==(const ContourGradationReport&, const ContourGradationReport&) = default;
};

/// Continue gradation across contours. Where a patch has larger sizes on a contour than another
/// patch there, it gets nodes with the minimum of both, and its sizes are graded from them. This is
/// repeated until all patches agree to 5 %, for at most forty rounds.
///
/// Sizes are carried across a contour as if the two tangent planes were unfolded around it.
/// Contours are compared at points at most two units apart. Does nothing if gradation is off.
///
/// Cost     a metric query for each patch and point; a control space is made anew in each round in
///          which its sizes on some contour are lowered
/// Pre      inputs and spaces are those of the patches, in their order
/// Throws   Cancelled
ContourGradationReport grade_across_contours(const Model& model, std::vector<ControlInput>& inputs,
                                             std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                             const RunContext& context = RunContext());

}  // namespace surfmesh
