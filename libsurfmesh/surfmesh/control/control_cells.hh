// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/control/cell_tree.hh"
#include "surfmesh/control/lattice_space.hh"

namespace surfmesh {

/// A control space of cells, halved where sizes change: bilinear in the quarters between the nodes
/// of each cell. The cells are its search structure, too.
///
/// A query reads the nodes of one cell only, even where a neighbour has further nodes on the common
/// side. There sizes jump, by less than divide_beside_finer() leaves.
class ControlCells : public LatticeSpace {
 public:
  /// Gives a node at a point, with the sizes wanted there.
  using SampleNode = std::function<ControlNode(Uv)>;

  /// Start with a grid of cells (CellTree), whose nodes are samples, as are those of all halves.
  /// `discs` are nodes of extended forms, see ControlSpace.
  ///
  /// Throws   InvalidOption; what `sample` throws
  ControlCells(const Domain& domain, CellCount roots, SampleNode sample,
               const ControlSpaceOptions& options, const std::vector<ControlNode>& discs);

  const CellTree& tree() const { return tree_; }

  /// Halve a leaf (CellTree::halve).
  void halve(int leaf, bool along_u);

  std::unique_ptr<LatticeSpace> changed_copy(const ChangeSize& change) const override;

  Uv cell_extent(int cell) const override { return tree_.extent(tree_.cell(cell)); }

  /// Cost     a query with its metric 60 ns near the last one, 120 ns elsewhere
  ///          (query_cells in tests/bench/control_bench.cc)
  Support support(Uv uv, int near) const override;

  std::vector<int> nodes_on_side(DomainSide side) const override;
  std::vector<int> divide_cell(Uv uv, const Metric& metric, double units) override;

  /// Only leaves are compared that are new, or that touch a node whose size has changed since the
  /// last call.
  std::vector<int> divide_beside_finer() override;

  /// How often a leaf was compared with its finer neighbours.
  std::size_t comparisons() const { return comparisons_; }

 protected:
  void announce_loose_node() override { tree_.add_loose_node(); }
  Neighbours neighbours(int node) const override;
  FaceList faces() const override { return tree_.faces(); }

 private:
  CellTree::MakeNode make_node();
  std::vector<char> changed_leaves();
  std::optional<bool> halving_beside_finer(int leaf);
  bool misses_finer(int leaf, bool along_u) const;

  SampleNode sample_;
  CellTree tree_;
  // What divide_beside_finer() began with the last time.
  std::vector<SizeTensor> compared_sizes_;  ///< by node
  std::size_t compared_cells_ = 0;          ///< number of cells
  std::size_t comparisons_ = 0;
};

}  // namespace surfmesh
