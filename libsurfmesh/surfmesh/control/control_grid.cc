// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_grid.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

std::size_t side_of(const std::vector<ControlNode>& regular) {
  const auto side =
      static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(regular.size()))));
  if (side < 2 || side * side != regular.size()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{} nodes are no square grid", regular.size()));
  }
  return side;
}

/// The eight nodes around each node of a grid.
NodeNeighbours neighbours_in_grid(int side) {
  std::vector<std::size_t> first = {0};
  std::vector<int> others;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      for (int row = std::max(0, j - 1); row <= std::min(side - 1, j + 1); ++row) {
        for (int column = std::max(0, i - 1); column <= std::min(side - 1, i + 1); ++column) {
          if (row != j || column != i) others.push_back(row * side + column);
        }
      }
      first.push_back(others.size());
    }
  }
  return NodeNeighbours(std::move(first), std::move(others));
}

}  // namespace

ControlGrid::ControlGrid(const Domain& domain, std::vector<ControlNode> regular,
                         const std::vector<ControlNode>& others, const ControlSpaceOptions& options)
    : ControlSpace(options, others),
      domain_(domain),
      side_(side_of(regular)),
      cells_per_u_(static_cast<double>(side_ - 1) / (domain.u1 - domain.u0)),
      cells_per_v_(static_cast<double>(side_ - 1) / (domain.v1 - domain.v0)) {
  for (const ControlNode& other : others) lower_cell(regular, other);
  if (options.grade > 0) {
    grade_sizes(regular, neighbours_in_grid(static_cast<int>(side_)), options.grade);
  }
  store_node_metrics(regular);
  make_mesh(regular);
  values_.reserve(regular.size());
  for (const ControlNode& node : regular) {
    values_.push_back(options.blend == Blend::Logarithmic ? log_size(node.size) : node.size);
  }
}

void ControlGrid::lower_cell(std::vector<ControlNode>& nodes, const ControlNode& other) const {
  const Uv uv = other.uv;
  if (!(uv.u >= domain_.u0 && uv.u <= domain_.u1 && uv.v >= domain_.v0 && uv.v <= domain_.v1)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("a control node at (u,v) = ({}, {}) lies outside the domain", uv.u, uv.v));
  }
  for (const std::size_t i : corners_of(find_cell(uv))) {
    nodes[i].size = minimum(nodes[i].size, other.size);
  }
}

ControlGrid::CellPoint ControlGrid::find_cell(Uv uv) const {
  const auto cells = static_cast<double>(side_ - 1);
  const double x = std::clamp((uv.u - domain_.u0) * cells_per_u_, 0.0, cells);
  const double y = std::clamp((uv.v - domain_.v0) * cells_per_v_, 0.0, cells);
  // The last node belongs to the last cell.
  const double column = std::min(std::trunc(x), cells - 1);
  const double row = std::min(std::trunc(y), cells - 1);
  return {static_cast<std::size_t>(row) * side_ + static_cast<std::size_t>(column), x - column,
          y - row};
}

std::array<std::size_t, 4> ControlGrid::corners_of(const CellPoint& cell) const {
  return {cell.node, cell.node + 1, cell.node + side_, cell.node + side_ + 1};
}

SizeTensor ControlGrid::interpolate(const SurfacePoint& at, QueryHint& hint) const {
  ++hint.answers.grid;
  const CellPoint cell = find_cell(at.uv);
  const auto [a, b, c, d] = corners_of(cell);
  const SizeTensor value =
      lerp(lerp(values_[a], values_[b], cell.s), lerp(values_[c], values_[d], cell.s), cell.t);
  return options().blend == Blend::Logarithmic ? exp_size(value) : value;
}

void ControlGrid::make_mesh(const std::vector<ControlNode>& nodes) {
  std::vector<std::array<int, 3>> triangles;
  const int side = static_cast<int>(side_);
  for (int row = 0; row + 1 < side; ++row) {
    for (int column = 0; column + 1 < side; ++column) {
      const int a = row * side + column;
      triangles.push_back({a, a + 1, a + side + 1});
      triangles.push_back({a, a + side + 1, a + side});
    }
  }
  build_triangles(mesh_, nodes.size(), triangles);
  const auto uv = attach(mesh_, keys::vertex_uv);
  const auto size = attach(mesh_, keys::vertex_size);
  for (const VertexHandle vh : mesh_.vertices()) {
    const ControlNode& node = nodes[index(vh)];
    mesh_.set_point(vh, to_openmesh(node.point));
    mesh_.property(uv, vh) = node.uv;
    mesh_.property(size, vh) = node.size;
  }
}

}  // namespace surfmesh
