// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/quality/sharp_contours.hh"

namespace surfmesh {

/// A point of a sharp contour, and how far the mesh is from it.
struct ContourDistance {
  int contour = -1;
  Vec3 point = Vec3::Zero();
  double distance = 0;
  FaceHandle face;  ///< the nearest one
};

/// Find the points of sharp contours that are farther than `least` from a mesh: a point of a border
/// from the nearest border edge, one of a crease from the nearest triangle.
///
/// Cost     O(n log n) for n points and elements of the mesh
/// Throws   Cancelled
std::vector<ContourDistance> far_contour_points(const PolyMesh& mesh,
                                                const std::vector<SharpContour>& contours,
                                                double least,
                                                const RunContext& context = RunContext());

}  // namespace surfmesh
