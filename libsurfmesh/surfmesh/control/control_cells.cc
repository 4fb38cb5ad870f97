// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_cells.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Share by which a cell may miss the size of a finer neighbour at a node on their common side, and
/// units of that size along it above which it is halved if it misses more.
constexpr double kMissBesideFiner = 0.1;
constexpr double kUnitsBesideFiner = 2;

}  // namespace

ControlCells::ControlCells(const Domain& domain, CellCount roots, SampleNode sample,
                           const ControlSpaceOptions& options,
                           const std::vector<ControlNode>& discs)
    : LatticeSpace(domain, options, discs),
      sample_(std::move(sample)),
      tree_(domain, roots, make_node()) {}

CellTree::MakeNode ControlCells::make_node() {
  return [this](Uv uv) { return add_node(sample_(uv)); };
}

std::unique_ptr<LatticeSpace> ControlCells::changed_copy(const ChangeSize& change) const {
  auto copy = std::make_unique<ControlCells>(*this);
  copy->change_sizes(change);
  copy->sample_ = [sample = sample_, change](Uv uv) {
    ControlNode node = sample(uv);
    node.size = change(node);
    return node;
  };
  return copy;
}

void ControlCells::halve(int leaf, bool along_u) { tree_.halve(leaf, along_u, make_node()); }

LatticeSpace::Support ControlCells::support(Uv uv, int near) const {
  const CellTree::Quarter quarter = tree_.quarter(uv, near);
  return {quarter.leaf, quarter.nodes, quarter.weights()};
}

std::vector<int> ControlCells::nodes_on_side(DomainSide side) const {
  switch (side) {
    case DomainSide::LowerU:
      return tree_.nodes_on_side(false, false);
    case DomainSide::UpperU:
      return tree_.nodes_on_side(false, true);
    case DomainSide::LowerV:
      return tree_.nodes_on_side(true, false);
    case DomainSide::UpperV:
      return tree_.nodes_on_side(true, true);
    default:
      return tree_.nodes_on_diagonal();
  }
}

std::vector<int> ControlCells::divide_cell(Uv uv, const Metric& metric, double units) {
  const int leaf = tree_.find(uv);
  const Uv size = tree_.extent(tree_.cell(leaf));
  const double along_u = squared_length(metric, {size.u, 0});
  const double along_v = squared_length(metric, {0, size.v});
  const bool is_along_u = along_u >= along_v;
  if (!(std::max(along_u, along_v) > units * units) || !tree_.can_halve(leaf, is_along_u)) {
    return {};
  }
  const int first = node_count();
  halve(leaf, is_along_u);
  return nodes_from(first);
}

/// True if a node of a finer neighbour has a smaller size than the leaf gives there, and the leaf
/// is long along the common side.
bool ControlCells::misses_finer(int leaf, bool along_u) const {
  const Uv extent = tree_.extent(tree_.cell(leaf));
  for (const int node : tree_.hanging_nodes(leaf, along_u)) {
    const Metric metric = metric_from_size(form(node), size(node));
    const double length =
        along_u ? metric.m11 * extent.u * extent.u : metric.m22 * extent.v * extent.v;
    if (!(length > kUnitsBesideFiner * kUnitsBesideFiner)) continue;
    int cell = leaf;
    const SizeTensor given = lattice_size(uv(node), cell);
    if (greatest_growth(given, size(node)) > kMissBesideFiner) return true;
  }
  return false;
}

/// The side along which a leaf is to be halved for a finer neighbour.
std::optional<bool> ControlCells::halving_beside_finer(int leaf) {
  if (!tree_.cell(leaf).is_leaf() || tree_.is_empty(tree_.cell(leaf))) return std::nullopt;
  ++comparisons_;
  for (const bool along_u : {true, false}) {
    if (tree_.can_halve(leaf, along_u) && misses_finer(leaf, along_u)) return along_u;
  }
  return std::nullopt;
}

/// The leaves that have not been compared as they are now. What a leaf gives, and what its finer
/// neighbours ask for, depends on the nodes that it touches alone.
std::vector<char> ControlCells::changed_leaves() {
  std::vector<char> is_changed(tree_.size(), 0);
  const std::size_t compared = compared_cells_ == 0 ? 0 : compared_sizes_.size();
  compared_sizes_.resize(static_cast<std::size_t>(node_count()));
  for (std::size_t node = 0; node < compared_sizes_.size(); ++node) {
    const int number = static_cast<int>(node);
    const SizeTensor now = size(number);
    const bool is_same = node < compared && now == compared_sizes_[node];
    compared_sizes_[node] = now;
    // At first, all leaves are new.
    if (is_same || compared_cells_ == 0) continue;
    for (const int leaf : tree_.leaves_around(uv(number))) {
      is_changed[static_cast<std::size_t>(leaf)] = 1;
    }
  }
  std::fill(is_changed.begin() + static_cast<std::ptrdiff_t>(compared_cells_), is_changed.end(), 1);
  compared_cells_ = tree_.size();
  return is_changed;
}

std::vector<int> ControlCells::divide_beside_finer() {
  const int first = node_count();
  std::vector<char> waits = changed_leaves();
  for (std::size_t i = 0; i < waits.size(); ++i) {
    if (!waits[i]) continue;
    const int leaf = static_cast<int>(i);
    const std::optional<bool> along_u = halving_beside_finer(leaf);
    if (!along_u) continue;
    const int first_new = node_count();
    halve(leaf, *along_u);
    // Leaves before this one have their turn in the next call, as the new ones have.
    for (const int node : nodes_from(first_new)) {
      for (const int other : tree_.leaves_around(uv(node))) {
        const auto at = static_cast<std::size_t>(other);
        if (at > i && at < waits.size()) waits[at] = 1;
      }
    }
  }
  return nodes_from(first);
}

LatticeSpace::Neighbours ControlCells::neighbours(int node) const {
  Neighbours result;
  for (const int leaf : tree_.leaves_of(node)) {
    if (leaf < 0) continue;
    const CellTree::Cell& cell = tree_.cell(leaf);
    const auto at = static_cast<std::size_t>(std::find(cell.nodes.begin(), cell.nodes.end(), node) -
                                             cell.nodes.begin());
    const std::size_t column = at % CellTree::kLattice, row = at / CellTree::kLattice;
    const auto lower = [](std::size_t x) { return x > 0 ? x - 1 : 0; };
    const auto upper = [](std::size_t x) { return std::min(x + 1, CellTree::kLattice - 1); };
    for (std::size_t j = lower(row); j <= upper(row); ++j) {
      for (std::size_t i = lower(column); i <= upper(column); ++i) {
        const int other = cell.node(i, j);
        if (other >= 0 && other != node) result.add(other);
      }
    }
  }
  return result;
}

}  // namespace surfmesh
