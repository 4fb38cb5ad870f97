// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pictures/depth_buffer.hh"

namespace surfmesh {

/// A part of a triangle that is seen.
struct PaintPiece {
  std::vector<ScenePoint> corners;  ///< a convex polygon
  PackedRgb colour = 0;
};

/// The triangles of a scene that are seen, in layers from back to front. The pieces of a layer do
/// not overlap where they are seen, so that they may be drawn in any order.
///
/// The depth buffer tells what is seen, and which visible triangle lies over which. Triangles that
/// pass through each other, or lie over each other in a circle, are cut at the plane of one of
/// them.
///
/// Error    a triangle that covers no sample is left out; where cuts do not help, the nearer ones
///          are drawn last
std::vector<std::vector<PaintPiece>> paint_order(const Scene& scene, const DepthBuffer& buffer);

}  // namespace surfmesh
