// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_grid.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

int side_of(const std::vector<ControlNode>& regular) {
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(regular.size()))));
  if (side < 2 ||
      static_cast<std::size_t>(side) * static_cast<std::size_t>(side) != regular.size()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} nodes are no square grid", regular.size()));
  }
  return side;
}

}  // namespace

ControlGrid::ControlGrid(const Domain& domain, const std::vector<ControlNode>& regular,
                         const ControlSpaceOptions& options, const std::vector<ControlNode>& discs)
    : LatticeSpace(domain, options, discs),
      side_(side_of(regular)),
      cells_per_u_((side_ - 1) / (domain.u1 - domain.u0)),
      cells_per_v_((side_ - 1) / (domain.v1 - domain.v0)) {
  for (const ControlNode& node : regular) add_node(node);
}

std::unique_ptr<LatticeSpace> ControlGrid::changed_copy(const ChangeSize& change) const {
  auto copy = std::make_unique<ControlGrid>(*this);
  copy->change_sizes(change);
  return copy;
}

LatticeSpace::Support ControlGrid::support(Uv uv, int /*near*/) const {
  const double last = side_ - 2;  // the last node belongs to the last cell
  const double x = std::clamp((uv.u - domain().u0) * cells_per_u_, 0.0, last + 1);
  const double y = std::clamp((uv.v - domain().v0) * cells_per_v_, 0.0, last + 1);
  const double column = std::min(std::trunc(x), last), row = std::min(std::trunc(y), last);
  const double s = x - column, t = y - row;
  // A cell has the number of the node at its lower corner.
  const int cell = static_cast<int>(row) * side_ + static_cast<int>(column);
  return {cell,
          {cell, cell + 1, cell + side_ + 1, cell + side_},
          {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}};
}

std::vector<int> ControlGrid::nodes_on_side(DomainSide side) const {
  const int last = side_ - 1;
  int first = 0, step = side_;  // along v at the lower u
  if (side == DomainSide::UpperU) first = last;
  if (side == DomainSide::LowerV || side == DomainSide::UpperV) step = 1;
  if (side == DomainSide::UpperV) first = last * side_;
  if (side == DomainSide::Diagonal) first = last, step = last;
  std::vector<int> nodes;
  for (int i = 0; i < side_; ++i) nodes.push_back(first + i * step);
  return nodes;
}

LatticeSpace::Neighbours ControlGrid::neighbours(int node) const {
  Neighbours result;
  if (node >= side_ * side_) return result;
  const int column = node % side_, row = node / side_;
  for (int j = std::max(0, row - 1); j <= std::min(side_ - 1, row + 1); ++j) {
    for (int i = std::max(0, column - 1); i <= std::min(side_ - 1, column + 1); ++i) {
      if (i != column || j != row) result.add(j * side_ + i);
    }
  }
  return result;
}

FaceList ControlGrid::faces() const {
  FaceList faces;
  for (int row = 0; row + 1 < side_; ++row) {
    for (int column = 0; column + 1 < side_; ++column) {
      const int a = row * side_ + column;
      faces.add(std::array{a, a + 1, a + side_ + 1, a + side_});
    }
  }
  return faces;
}

}  // namespace surfmesh
