// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/control_nodes.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/sampling/control_cells.hh"

namespace surfmesh {
namespace {

/// Most regular nodes: far more than sizes that elements can follow ever need in one patch.
constexpr int kMostRegularNodes = 4'000'000;

std::vector<ControlNode> regular_nodes(const SizeField& field, int count) {
  const Domain domain = field.surface().domain();
  if (count > kMostRegularNodes) {
    throw Error(ErrorCode::Limit, fmt::format("{} control nodes in one patch are more than {}",
                                              count, kMostRegularNodes));
  }
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
  if (options.regular < 0 || (options.regular > 0 && options.regular < 4)) {
    throw Error(
        ErrorCode::InvalidOption,
        fmt::format("nodes = {} is outside its range: auto, or 4 and above", options.regular));
  }
  if (!(options.precision > 0)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("precision = {} is outside its range: above 0", options.precision));
  }
}

ChosenNodes choose_control_nodes(const SizeField& field, const ControlNodeOptions& options) {
  check(options);
  if (options.regular > 0) return {regular_nodes(field, options.regular)};
  detail::ControlCells cells(field, options.by_distance);
  const bool is_held = cells.refine(options.precision);
  return {cells.nodes(), !is_held};
}

}  // namespace surfmesh
