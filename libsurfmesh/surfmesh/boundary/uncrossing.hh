// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/boundary/contour_division.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// By contour of the model; degenerate contours, and those that no patch uses, have none.
using ContourDivisions = std::vector<std::optional<ContourDivision>>;

/// Halve segments until the loops of patches, whose curves do not cross, do not either, nor are in
/// the way of the rings that cut off poles.
///
/// The numbers of segments stay multiples of `multiple`. The nodes stay as they are where that does
/// not succeed: curves that touch are found later.
/// Cost     O(n log n) for n segments in up to 40 rounds
/// Throws   Cancelled
void uncross(const Model& model, ContourDivisions& divisions, int multiple,
             const RunContext& context = RunContext());

}  // namespace surfmesh
