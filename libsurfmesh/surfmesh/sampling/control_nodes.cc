// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/control_nodes.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/sampling/node_cells.hh"

namespace surfmesh {
namespace {

std::vector<ControlNode> regular_nodes(const SizeField& field, int count) {
  const Domain domain = field.surface().domain();
  const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(count))));
  const double width = (domain.u1 - domain.u0) / (side - 1);
  const double height = (domain.v1 - domain.v0) / (side - 1);
  const Metric spacing{1 / (width * width), 0, 1 / (height * height)};
  std::vector<ControlNode> nodes;
  nodes.reserve(static_cast<std::size_t>(side * side));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const Uv uv = domain.at(double(i) / (side - 1), double(j) / (side - 1));
      const SizeField::Sample sample = field.at(uv);
      nodes.push_back({uv, sample.point, sample.form, sample.size, spacing});
    }
  }
  return nodes;
}

}  // namespace

void check(const ControlNodeOptions& options) {
  check_option(ranges::kNodes, options.regular);
  check_option(ranges::kPrecision, options.precision);
}

ChosenNodes choose_control_nodes(const SizeField& field, const ControlNodeOptions& options) {
  check(options);
  if (options.regular > 0) return {regular_nodes(field, options.regular)};
  detail::NodeCells cells(field, options.by_distance);
  const bool is_held = cells.refine(options.precision);
  return {cells.nodes(), !is_held};
}

}  // namespace surfmesh
