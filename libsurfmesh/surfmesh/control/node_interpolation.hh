// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/control/control_node.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The corners of a surface's bounding rectangle, each with the size of the node nearest in space.
///
/// Pre      at least one node
std::vector<ControlNode> corners_like_nearest(const Surface& surface,
                                              const std::vector<ControlNode>& nodes);

/// Interpolates sizes that are given at nodes only. The nodes, and the corners of the rectangle
/// with the value of the nearest node, are triangulated and interpolated as a control space without
/// gradation.
class NodeInterpolation {
 public:
  /// Corners of the rectangle may be among the nodes.
  /// Pre      at least one node, all in the bounding rectangle
  NodeInterpolation(const Surface& surface, const std::vector<ControlNode>& nodes);

  /// A size, and the triangle that it comes from.
  struct Answer {
    SizeTensor size;
    int triangle = -1;
  };

  /// Points where the sizes may be smaller than all around: the nodes, the corners, and points
  /// along the edges between them, about one of the smaller sizes of an edge apart; at most 64 on
  /// an edge and 20,000 in all.
  std::vector<Uv> points() const;

  /// Cost     60 to 400 ns
  Answer at(const SurfacePoint& at) const;

 private:
  std::shared_ptr<const ControlMesh> control_;
};

}  // namespace surfmesh
