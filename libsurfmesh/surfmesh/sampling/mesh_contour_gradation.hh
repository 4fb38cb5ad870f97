// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/contour_gradation.hh"

namespace surfmesh::detail {

/// Continue gradation across contours between triangulations of nodes (ControlMesh).
///
/// A patch that has larger sizes on a contour than another one gets nodes there with the minimum of
/// both, and its control space is made anew. Contours are compared at points two units apart at
/// most. It ends: no point gets a node twice but with a size that is smaller by 5 %, and none below
/// the least size of all.
///
/// Cost     a metric query for each patch and point; in each round, the control spaces of all
///          patches that have got nodes
ContourGradationReport grade_meshes_across_contours(
    const Model& model, std::vector<ControlInput>& inputs,
    std::vector<std::unique_ptr<ControlSpace>>& spaces, const RunContext& context);

}  // namespace surfmesh::detail
