// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// Rows of nodes along u at the front of a list, which cover a rectangle with one spacing.
struct RegularRows {
  std::size_t width = 0;   ///< nodes in a row
  std::size_t height = 0;  ///< rows

  std::size_t count() const { return width * height; }
};

/// The rows at the front of a list of nodes, from the lower left corner of the rectangle of a
/// domain to the upper right one; none if the list does not begin with such rows, or their
/// spacing is not along them.
///
/// Cost     O(n) for n nodes in such rows
RegularRows find_regular_rows(const Domain& domain, const std::vector<ControlNode>& nodes);

/// Triangles between the nodes of rows, counter-clockwise: a Delaunay triangulation in the metric
/// of the spacing. Diagonals alternate, so that no direction is preferred.
std::vector<std::array<int, 3>> triangles_between(const RegularRows& rows);

}  // namespace surfmesh
