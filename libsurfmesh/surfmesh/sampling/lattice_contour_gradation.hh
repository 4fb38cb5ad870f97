// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/contour_gradation.hh"

namespace surfmesh::detail {

/// Continue gradation across contours between lattices (LatticeSpace).
///
/// Each node of a patch on a contour takes the minimum with what the other patches give at its
/// place, and the patch is graded from the nodes that came down. This is repeated until no node
/// comes down by more than 2 %. It ends: both lengths of a size only fall, each time by a share,
/// and never below the least one of all.
///
/// Then, where a patch cannot give between its nodes what another one has, its cells there are
/// halved, down to two units, and it is repeated. Cells that are short end this.
///
/// Source   DECISIONS.md, sampling
ContourGradationReport grade_lattices_across_contours(
    const Model& model, const std::vector<std::unique_ptr<ControlSpace>>& spaces,
    const RunContext& context);

}  // namespace surfmesh::detail
