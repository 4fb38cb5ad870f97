// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Set Contour::is_smooth of all contours: false where only one patch ends, or where the tangent
/// planes of the patches differ. Degenerate contours are smooth.
///
/// Cost     a few tens of evaluations a contour of two patches, more where speeds differ
void set_smoothness(Model& model);

}  // namespace surfmesh
