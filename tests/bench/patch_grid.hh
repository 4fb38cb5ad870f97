// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh::judge {

/// A regular grid over the bounding rectangle of a domain, whose lines include those between the
/// cells of the surface.
struct PatchGrid {
  Domain domain;
  int u_steps = 1;
  int v_steps = 1;

  int columns() const { return u_steps + 1; }
  int rows() const { return v_steps + 1; }
  std::size_t node_count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }

  /// The index of a node in rows along u.
  std::size_t node(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column);
  }

  Uv at(int column, int row) const {
    return domain.at(double(column) / u_steps, double(row) / v_steps);
  }

  /// A point in steps of the grid.
  Uv in_steps(Uv uv) const;

  /// Four nodes around a point, with their weights for bilinear interpolation.
  struct Corners {
    std::array<std::size_t, 4> nodes;
    std::array<double, 4> weights;
  };
  Corners corners_at(Uv uv) const;

  /// Half as wide steps.
  PatchGrid refined() const { return {domain, 2 * u_steps, 2 * v_steps}; }
};

/// A grid of about `nodes` nodes, but at least two steps in each cell, with steps that are about as
/// long in both directions.
PatchGrid make_grid(const Surface& surface, double nodes);

}  // namespace surfmesh::judge
