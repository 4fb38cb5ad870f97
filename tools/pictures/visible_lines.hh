// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pictures/depth_buffer.hh"

namespace surfmesh {

/// How edges are drawn.
struct LineOptions {
  bool edges = true;        ///< sides of all faces
  bool contours = true;     ///< contours, thicker
  double edge_width = 0.5;  ///< pixels
  double contour_width = 1.3;
};

/// Lines of one style.
struct StyledLines {
  PictureStyle style;
  std::vector<PicturePoints> lines;
};

/// What is seen of the edges of a scene, contours last.
///
/// Where faces are narrow, their edges fade: lines never take more than a share of the area of
/// their faces, so that a fine mesh stays bright.
///
/// Error    lines end within half a pixel of where something hides them
/// Cost     O(edges and the half pixels of their lengths)
std::vector<StyledLines> visible_lines(const Scene& scene, const DepthBuffer& buffer,
                                       const LineOptions& options);

}  // namespace surfmesh
