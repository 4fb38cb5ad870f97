// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model/named_contours.hh"

/// A step of trim_patches: a contour with corners inside becomes several.
namespace surfmesh {

/// The parts of a contour between the kinks inside it, in its direction: `hole#0`, `hole#1`, ... A
/// contour without kinks is its only part, and keeps its name.
///
/// A mesh has vertices where contours end, and would cut off a corner inside one.
/// Pre      as curve_in_space
/// Cost     that of curve_kinks, and of project_to_curve for each kink and curve of another speed
std::vector<ContourInput> divide_at_kinks(const ContourInput& contour,
                                          const std::vector<PatchInput>& patches,
                                          const PatchNumbers& patch_numbers);

/// True for the name of a contour or of a part that divide_at_kinks makes of it.
bool is_part_of(std::string_view part, std::string_view contour);

}  // namespace surfmesh
