// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Points on a contour along which the surface ends or has a crease.
struct SharpContour {
  int contour = -1;       ///< index in the model
  bool is_border = true;  ///< the surface ends there
  std::vector<Vec3> points;
};

/// The contours along which a mesh may cut off a part of the surface without any triangle being far
/// from it: those that are not smooth.
///
/// Chords between points are nearer to the contour than `tolerance` (model units).
/// Cost     that of curve_polyline for each
/// Throws   Cancelled
std::vector<SharpContour> sharp_contours(const Model& model, double tolerance,
                                         const RunContext& context = RunContext());

}  // namespace surfmesh
