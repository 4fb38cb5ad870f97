// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "surfmesh/control/control_node.hh"

namespace surfmesh {

/// The neighbours of each of a number of nodes, one list after the other.
class NodeNeighbours {
 public:
  /// `first` holds where the list of each node begins, and the end of the last one.
  NodeNeighbours(std::vector<std::size_t> first, std::vector<int> others)
      : first_(std::move(first)), others_(std::move(others)) {}

  std::span<const int> of(std::size_t node) const {
    return {others_.data() + first_[node], first_[node + 1] - first_[node]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<int> others_;
};

/// Lower sizes until they grow by at most ln(grade) per unit of length from each node to its
/// neighbours, to within 0.1 %. Sizes that already do are unchanged, bit by bit.
///
/// Cost     about 0.1 µs per pair of neighbours, and as much for each size that is lowered
/// Pre      grade is at least 1
/// Source   graded()
void grade_sizes(std::vector<ControlNode>& nodes, const NodeNeighbours& neighbours, double grade);

}  // namespace surfmesh
