// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/grade_sizes.hh"

#include <cmath>
#include <deque>

#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/gradation.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// A size that gradation lowers by less is left as it is, so that it ends.
constexpr double kLeastGradation = 1e-3;

/// The extreme lengths of a size tensor, to tell without its directions that no limit is reached.
struct Range {
  double least;
  double greatest;
};

Range range_of(const SizeTensor& h) {
  const double mean = 0.5 * (h.h11 + h.h22), half_difference = 0.5 * (h.h11 - h.h22);
  const double radius = std::sqrt(half_difference * half_difference + h.h12 * h.h12);
  return {mean - radius, mean + radius};
}

/// Waiting nodes, each once.
class NodeQueue {
 public:
  explicit NodeQueue(std::size_t count) : is_queued_(count, 1) {
    for (std::size_t i = 0; i < count; ++i) queue_.push_back(i);
  }

  bool is_empty() const { return queue_.empty(); }

  void push(std::size_t node) {
    if (!is_queued_[node]) queue_.push_back(node);
    is_queued_[node] = 1;
  }

  std::size_t pop() {
    const std::size_t node = queue_.front();
    queue_.pop_front();
    is_queued_[node] = 0;
    return node;
  }

 private:
  std::deque<std::size_t> queue_;
  std::vector<char> is_queued_;
};

}  // namespace

void grade_sizes(std::vector<ControlNode>& nodes, const NodeNeighbours& neighbours, double grade) {
  NodeQueue queue(nodes.size());
  const double growth = std::log(grade);
  while (!queue.is_empty()) {
    const std::size_t i = queue.pop();
    const ControlNode& from = nodes[i];
    const Metric metric = metric_from_size(from.form, from.size);
    const double least = range_of(from.size).least;
    for (const int j : neighbours.of(i)) {
      ControlNode& to = nodes[static_cast<std::size_t>(j)];
      const double length_m = std::sqrt(squared_length(metric, to.uv - from.uv));
      if (range_of(to.size).greatest <= least * (1 + growth * length_m)) continue;
      const SizeTensor lowered = graded(to.size, from.size, length_m, grade);
      if (log_conformity(to.size, lowered) <= kLeastGradation) continue;
      to.size = lowered;
      queue.push(static_cast<std::size_t>(j));
    }
  }
}

}  // namespace surfmesh
