// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "surfmesh/control/control_node.hh"

namespace surfmesh {

/// The sizes that a node of an extended form asks for at a point in space; none beyond its discs.
///
/// M within the first radius; over the second it changes to M′, linearly in H.
/// Source   paper, section 3.1
std::optional<SizeTensor> extended_size(const ControlNode& node, const Vec3& point);

/// The nodes of extended forms of one patch, found by the points that their discs contain.
class NodeDiscs {
 public:
  /// Keeps the nodes that have a radius.
  explicit NodeDiscs(const std::vector<ControlNode>& nodes);

  /// The minimum of the sizes of all discs that contain a point, in the order of the nodes.
  ///
  /// Cost     O(log n + number of these discs)
  std::optional<SizeTensor> size_at(const Vec3& point) const;

 private:
  std::vector<ControlNode> nodes_;
  Eigen::KdBVH<double, 3, int> tree_;
};

}  // namespace surfmesh
