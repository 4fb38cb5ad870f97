// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "surfmesh/sizes/placed_size.hh"

namespace surfmesh {

/// Many placed sizes, with fast queries of their minimum at a point.
///
/// A hierarchy of boxes in space. A box is skipped if the least size in it, grown by the grade over
/// the distance to the box, is not below the larger of the sizes found so far. Immutable; several
/// threads may query it at once.
class SourceTree {
 public:
  /// Units    grade as in Sizing: 0 (off), or at least 1
  /// Cost     O(n log² n), about 1 µs per size
  SourceTree(std::vector<PlacedSize> sizes, double grade);

  /// The minimum of a size and all placed sizes at a point. The order in which they are combined
  /// depends only on the tree and the point.
  ///
  /// Cost     O(log n + k) for k sizes that are below the others somewhere nearby
  SizeTensor minimum_at(const TangentFrame& place, const SizeTensor& size) const;

  bool empty() const { return sizes_.empty(); }
  const std::vector<PlacedSize>& sizes() const { return sizes_; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    double least = 0;  ///< length
    double rate = 0;   ///< growth of the least length per unit of distance beyond `reach`
    double reach = 0;
    int first = 0;   ///< of its sizes
    int count = 0;   ///< of its sizes; 0 for an inner node
    int second = 0;  ///< the second child; the first one follows its parent
  };

  int build(std::vector<int>& order, int first, int last, const std::vector<PlacedSize>& sizes);
  Node leaf_over(const std::vector<int>& order, int first, int last,
                 const std::vector<PlacedSize>& sizes) const;
  double bound(const Node& node, const Vec3& point) const;

  double growth_;
  std::vector<PlacedSize> sizes_;  ///< in the order of the leaves
  std::vector<Node> nodes_;
};

}  // namespace surfmesh
