// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

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

/// `size` limited to `factor` times the size `from`, or `size` itself, bit by bit, if that lowers
/// it by less than 0.1 %.
///
/// Never below the least length of both, although the minimum of two stretched sizes that cross can
/// be: so no chain of such limits goes below the least size that it began with.
/// Pre      factor is at least 1
SizeTensor limited_size(const SizeTensor& size, const SizeTensor& from, double factor = 1);

/// Grades the sizes of nodes: from each node to its neighbours, sizes grow by at most ln(grade) per
/// unit of length, to within 0.1 %; to within 5 % where stretched sizes cross, which limited_size
/// bounds. Sizes that already do are unchanged, bit by bit.
///
/// The node of the least size comes first. Its size is final then, but for its greater length, so
/// nearly every node is visited once.
///
/// `Net` gives the nodes: uv(i), form(i), size(i), set_size(i, size), and
/// for_each_neighbour(i, visit).
/// Cost     O(n log n); in sampling/make_control.hh, a third of the cost of cells
/// Pre      grade is at least 1
template <class Net>
class Gradation {
 public:
  Gradation(Net& net, double grade) : net_(net), growth_(std::log(grade)) {}

  /// Let the size of a node reach others.
  void start_from(int node) {
    const auto index = static_cast<std::size_t>(node);
    if (is_waiting_.size() <= index) is_waiting_.resize(index + 1, 0);
    is_waiting_[index] = 1;
    queue_.push({size_range(net_.size(node)).least, node});
  }

  /// Grade from all nodes that were started from.
  /// Throws   Cancelled
  void run(const RunContext& context) {
    for (std::size_t steps = 1; !queue_.empty(); ++steps) {
      if (steps % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
      const auto [least, node] = queue_.top();
      queue_.pop();
      // Lowered since: it is in the queue once more, and was visited then. Or it is there more
      // than once with the same least length, of which one visit is enough.
      char& is_waiting = is_waiting_[static_cast<std::size_t>(node)];
      if (is_waiting == 0 || least != size_range(net_.size(node)).least) continue;
      is_waiting = 0;
      spread(node, least);
    }
  }

 private:
  using Entry = std::pair<double, int>;

  void spread(int node, double least) {
    const SizeTensor size = net_.size(node);
    const Metric metric = metric_from_size(net_.form(node), size);
    const Uv uv = net_.uv(node);
    net_.for_each_neighbour(node, [&](int other) {
      const double length_m = std::sqrt(squared_length(metric, net_.uv(other) - uv));
      const SizeTensor there = net_.size(other);
      const double factor = 1 + growth_ * length_m;
      if (size_range(there).greatest <= least * factor) return;
      const SizeTensor limited = limited_size(there, size, factor);
      if (limited == there) return;
      net_.set_size(other, limited);
      start_from(other);
    });
  }

  Net& net_;
  double growth_;
  std::vector<char> is_waiting_;  ///< by node: changed since it was last visited
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// Grade the sizes of nodes with given neighbours.
void grade_sizes(std::vector<ControlNode>& nodes, const NodeNeighbours& neighbours, double grade,
                 const RunContext& context = RunContext());

}  // namespace surfmesh
