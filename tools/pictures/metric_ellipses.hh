// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "pictures/canvas.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Ellipses over the plane of a patch, and how large they are.
struct MetricEllipses {
  std::vector<PicturePoints> outlines;
  double factor = 1;  ///< of the sizes that the metric asks for: their diameter is as long as an
                      ///< edge, times this
};

/// The metric at vertices of a patch as ellipses around them: as wide in each direction as an edge
/// should be long, or larger by one factor where most could not be seen. Of those that overlap, or
/// leave the frame, some are left out.
///
/// Reads    surf:uv, surf:metric, surf:beyond (halfedge; the last optional), surf:patch (face)
/// Throws   MissingProperty
/// Pre      `place` is affine
MetricEllipses metric_ellipses(const PolyMesh& mesh, int patch,
                               const std::function<PicturePoint(Uv)>& place,
                               const PictureFrame& frame);

}  // namespace surfmesh
