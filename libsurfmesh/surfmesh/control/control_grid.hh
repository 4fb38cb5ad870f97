// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/control/lattice_space.hh"

namespace surfmesh {

/// A control space of regular nodes in the bounding rectangle of a domain, with bilinear
/// interpolation: exact to second order, a query is a look-up.
/// Source   paper, section 1, the regular grid
class ControlGrid : public LatticeSpace {
 public:
  /// Take side × side regular nodes, in rows along u from the lower corner. `discs` are nodes of
  /// extended forms, see ControlSpace.
  ///
  /// Throws   InvalidInput if the number of nodes is not a square of at least 4; InvalidOption
  ControlGrid(const Domain& domain, const std::vector<ControlNode>& regular,
              const ControlSpaceOptions& options, const std::vector<ControlNode>& discs = {});

  std::unique_ptr<LatticeSpace> changed_copy(const ChangeSize& change) const override;

  Uv cell_extent(int) const override { return {1 / cells_per_u_, 1 / cells_per_v_}; }

  /// Cost     a query with its metric 35 ns (query_grid in tests/bench/control_bench.cc)
  Support support(Uv uv, int near) const override;

  std::vector<int> nodes_on_side(DomainSide side) const override;

  /// The nodes stay as they are.
  std::vector<int> divide_cell(Uv, const Metric&, double) override { return {}; }

 protected:
  void announce_loose_node() override {}
  Neighbours neighbours(int node) const override;
  FaceList faces() const override;

 private:
  int side_;
  double cells_per_u_;
  double cells_per_v_;
};

}  // namespace surfmesh
