// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model/model.hh"

/// The step of model_from_patches that looks for jumps and infinite points of formulas.
namespace surfmesh {

/// Add a shortfall to a model for each jump that the formula surfaces of its patches have inside
/// the boundary, of at most kMostBreaks a patch. `patches` are the inputs of its patches.
///
/// Error    as find_breaks; surfaces other than FormulaSurface are not searched
/// Throws   Geometry for a surface that runs to infinity inside the boundary, naming the patch and
///          (u,v)
void check_breaks(const std::vector<PatchInput>& patches, Model& model);

/// Fail if a curve of a contour that is given by formulas jumps or runs to infinity.
///
/// Error    as find_breaks
/// Throws   Geometry, naming t
void check_breaks(const ContourInput& contour);

}  // namespace surfmesh
