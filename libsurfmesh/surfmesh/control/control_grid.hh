// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/lattice_space.hh"

namespace surfmesh {

/// A control space of regular nodes in the bounding rectangle of a domain, with bilinear
/// interpolation: exact to second order, a query is a look-up.
/// Source   paper, section 1, the regular grid
class ControlGrid : public LatticeSpace {
 public:
  /// Take side × side regular nodes, in rows along u from the lower corner. Each further node
  /// lowers the sizes at the corners of its cell.
  ///
  /// Cost     about 0.1 µs per node
  /// Throws   InvalidInput if the number of nodes is not a square of at least 4, or for a node
  ///          outside the rectangle, naming its (u,v); InvalidOption
  ControlGrid(const Domain& domain, const std::vector<ControlNode>& regular,
              const std::vector<ControlNode>& others, const ControlSpaceOptions& options);

  int find_cell(Uv uv, int near) const override;

  /// Cost     below 20 ns with the metric (tests/bench/control_bench.cc)
  Support support(int cell, Uv uv) const override;

  std::vector<int> nodes_on_side(DomainSide side) const override;

  /// The nodes stay as they are.
  std::vector<int> divide_cell(Uv, const Metric&, double) override { return {}; }

 protected:
  void announce_loose_node() override {}
  Neighbours neighbours(int node) const override;
  FaceList faces() const override;

 private:
  void lower_cell(const ControlNode& other);

  int side_;
  double cells_per_u_;
  double cells_per_v_;
};

}  // namespace surfmesh
