// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Boxes, with fast queries of those that meet another one.
///
/// A hierarchy of boxes, halved where they begin along the axis on which they spread most.
/// Immutable; several threads may query it at once. Boxes that are empty or not a number meet none.
class BoxTree {
 public:
  using Box = Eigen::AlignedBox3d;

  /// Cost     O(n log² n)
  explicit BoxTree(std::vector<Box> boxes);

  /// The indices of the boxes that have a point in common with a box, in growing order.
  ///
  /// Cost     O(log n + k log k) for k of them, unless many boxes overlap each other
  std::vector<std::size_t> meeting(const Box& box) const;

  /// Call a function for the index of each box that meets a box, in no particular order.
  ///
  /// Returns  how many boxes were compared with it, those of the hierarchy included
  std::size_t visit(const Box& box, const std::function<void(std::size_t)>& found) const;

 private:
  struct Node {
    Box box;
    std::size_t first = 0;   ///< of its boxes in `order_`
    std::size_t count = 0;   ///< of its boxes; 0 for an inner node
    std::size_t second = 0;  ///< the second child; the first one follows its parent
  };

  std::size_t build(std::size_t first, std::size_t last);

  std::vector<Box> boxes_;
  std::vector<std::size_t> order_;  ///< indices of boxes, leaf by leaf
  std::vector<Node> nodes_;
};

/// A box of the (u,v) plane for a BoxTree.
inline BoxTree::Box plane_box(Uv low, Uv high) {
  return {Vec3(low.u, low.v, 0), Vec3(high.u, high.v, 0)};
}

}  // namespace surfmesh
