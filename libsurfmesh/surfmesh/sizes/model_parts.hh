// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// The diagonals of the parts of a model, by patch. A part is what hangs together by contours.
///
/// Error    from samples of surfaces, which of trimmed patches are seen whole
/// Cost     9 × 9 evaluations for each cell of a surface, 100 × 100 at most a patch
std::vector<double> part_diagonals(const Model& model);

}  // namespace surfmesh
