// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/model/side_chains.hh"

/// The step of model_from_patches that makes loops of named contours.
namespace surfmesh {

struct TrimInput {
  const std::vector<PatchInput>& patches;
  const std::vector<ContourInput>& contours;
  const SideChains& chains;
  double join = 0;  ///< places this near are one place, in model units
};

/// The name that stands in a loop, without its sign.
std::string_view contour_name_of(std::string_view mention);

/// Add the contours that loops name to a model, and the loops to those patches that have some.
///
/// `model` has all patches, and the contours and vertices that their sides make. See
/// model_from_patches.
void trim_patches(Model& model, const TrimInput& input);

}  // namespace surfmesh
