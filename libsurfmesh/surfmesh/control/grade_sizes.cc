// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/grade_sizes.hh"

#include <algorithm>

#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// A size that gradation lowers by less is left as it is, so that it ends.
constexpr double kLeastGradation = 1e-3;

class ListedNodes {
 public:
  ListedNodes(std::vector<ControlNode>& nodes, const NodeNeighbours& neighbours)
      : nodes_(nodes), neighbours_(neighbours) {}

  Uv uv(int i) const { return node(i).uv; }
  const FirstFormFactor& form(int i) const { return node(i).form; }
  const SizeTensor& size(int i) const { return node(i).size; }
  void set_size(int i, const SizeTensor& size) { nodes_[static_cast<std::size_t>(i)].size = size; }

  template <class Visit>
  void for_each_neighbour(int i, Visit visit) const {
    for (const int other : neighbours_.of(static_cast<std::size_t>(i))) visit(other);
  }

 private:
  const ControlNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

  std::vector<ControlNode>& nodes_;
  const NodeNeighbours& neighbours_;
};

}  // namespace

SizeTensor limited_size(const SizeTensor& size, const SizeTensor& from, double factor) {
  SizeTensor limited = minimum(size, scaled(from, factor));
  const double least = std::min(size_range(size).least, size_range(from).least);
  const SizeRange range = size_range(limited);
  if (range.least < least) limited = clamp_sizes(limited, least, std::max(least, range.greatest));
  return greatest_growth(size, limited) <= kLeastGradation ? size : limited;
}

void grade_sizes(std::vector<ControlNode>& nodes, const NodeNeighbours& neighbours, double grade,
                 const RunContext& context) {
  ListedNodes net(nodes, neighbours);
  Gradation gradation(net, grade);
  for (std::size_t i = 0; i < nodes.size(); ++i) gradation.start_from(static_cast<int>(i));
  gradation.run(context);
}

}  // namespace surfmesh
