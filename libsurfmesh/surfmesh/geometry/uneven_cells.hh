// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The cells between uneven lines of a domain, for surfaces that consist of such (knot spans).
struct UnevenCells {
  std::vector<double> u;  ///< ascending, from the start of the domain to its end
  std::vector<double> v;  ///< likewise

  CellCount count() const {
    return {static_cast<int>(u.size()) - 1, static_cast<int>(v.size()) - 1};
  }

  /// See Surface::from_cells and Surface::to_cells.
  /// Cost     that of to_cells is logarithmic
  Uv from_cells(Uv cells) const;
  Uv to_cells(Uv uv) const;
};

}  // namespace surfmesh
