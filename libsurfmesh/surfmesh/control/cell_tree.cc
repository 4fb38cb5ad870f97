// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/cell_tree.hh"

#include <algorithm>
#include <bit>

namespace surfmesh {
namespace {

/// Grid lines along all roots together: 2 to this power at most, so that the sum of two coordinates
/// fits.
constexpr int kMostBits = 30;

/// A cell of fewer lines has no room for two lattices.
constexpr std::uint32_t kLeastLines = 4;

std::uint64_t key_of(std::uint32_t i, std::uint32_t j) { return std::uint64_t{i} << 32 | j; }

std::uint32_t middle(std::uint32_t a, std::uint32_t b) { return a + (b - a) / 2; }

}  // namespace

std::array<double, 4> CellTree::Quarter::weights() const {
  if (nodes[2] < 0) return {1 - s - t, s, 0, t};
  return {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
}

CellTree::CellTree(const Domain& domain, CellCount roots, const MakeNode& make_node)
    : domain_(domain), roots_(roots), is_triangle_(domain.shape == Domain::Shape::Triangle) {
  const auto most = static_cast<std::uint32_t>(std::max(roots.u, roots.v));
  root_size_ = 1u << (kMostBits - std::bit_width(most));
  end_i_ = static_cast<std::uint32_t>(roots.u) * root_size_;
  end_j_ = static_cast<std::uint32_t>(roots.v) * root_size_;
  lines_per_u_ = end_i_ / (domain.u1 - domain.u0);
  lines_per_v_ = end_j_ / (domain.v1 - domain.v0);
  for (std::uint32_t j = 0; j < end_j_; j += root_size_) {
    for (std::uint32_t i = 0; i < end_i_; i += root_size_) {
      cells_.push_back({i, j, i + root_size_, j + root_size_});
      make_lattice(static_cast<int>(cells_.size()) - 1, make_node);
    }
  }
}

bool CellTree::can_halve(int leaf, bool along_u) const {
  const Cell& c = cell(leaf);
  return (along_u ? c.i1 - c.i0 : c.j1 - c.j0) >= kLeastLines;
}

bool CellTree::is_cut(const Cell& c) const {
  return is_triangle_ && c.i0 + c.j0 < end_i_ && c.i1 + c.j1 > end_i_;
}

bool CellTree::is_beyond_diagonal(std::uint32_t i, std::uint32_t j) const {
  return is_triangle_ && i + j > end_i_;
}

// --- halving ---

void CellTree::halve(int leaf, bool along_u, const MakeNode& make_node) {
  const bool is_quartered = is_cut(cell(leaf));
  forget_leaf(leaf);
  split(leaf, along_u);
  const int lower = cell(leaf).first_half;
  if (!is_quartered) {
    make_lattice(lower, make_node);
    make_lattice(lower + 1, make_node);
    return;
  }
  for (const int half : {lower, lower + 1}) {
    split(half, !along_u);
    const int first = cell(half).first_half;
    make_lattice(first, make_node);
    make_lattice(first + 1, make_node);
  }
}

/// Give a cell its two halves, without nodes.
void CellTree::split(int index, bool along_u) {
  Cell first = cell(index);
  first.first_half = -1;
  first.nodes.fill(-1);
  Cell second = first;
  if (along_u) {
    first.i1 = second.i0 = middle(first.i0, first.i1);
  } else {
    first.j1 = second.j0 = middle(first.j0, first.j1);
  }
  Cell& halved = cells_[static_cast<std::size_t>(index)];
  halved.first_half = static_cast<int>(cells_.size());
  halved.is_halved_along_u = along_u;
  cells_.push_back(first);
  cells_.push_back(second);
}

CellTree::Lines CellTree::lines_of(const Cell& c) {
  return {{c.i0, middle(c.i0, c.i1), c.i1}, {c.j0, middle(c.j0, c.j1), c.j1}};
}

void CellTree::make_lattice(int index, const MakeNode& make_node) {
  Cell& c = cells_[static_cast<std::size_t>(index)];
  c.nodes.fill(-1);
  // Nodes on the diagonal belong to the cells that have an area in the domain.
  if (is_triangle_ && c.i0 + c.j0 >= end_i_) return;
  const Lines lines = lines_of(c);
  for (std::size_t k = 0; k < c.nodes.size(); ++k) {
    const std::uint32_t i = lines.i[k % kLattice], j = lines.j[k / kLattice];
    if (is_beyond_diagonal(i, j)) continue;
    c.nodes[k] = make_crossing(i, j, make_node);
    replace_leaf(c.nodes[k], -1, index);
  }
}

int CellTree::make_crossing(std::uint32_t i, std::uint32_t j, const MakeNode& make_node) {
  const auto [entry, is_new] = crossings_.try_emplace(key_of(i, j), -1);
  if (is_new) {
    entry->second = make_node(domain_.at(double(i) / end_i_, double(j) / end_j_));
    leaves_of_.push_back(kNoLeaves);
  }
  return entry->second;
}

void CellTree::replace_leaf(int node, int old_leaf, int new_leaf) {
  auto& leaves = leaves_of_[static_cast<std::size_t>(node)];
  *std::find(leaves.begin(), leaves.end(), old_leaf) = new_leaf;
}

void CellTree::forget_leaf(int index) {
  for (const int node : cell(index).nodes) {
    if (node >= 0) replace_leaf(node, index, -1);
  }
}

// --- location ---

CellTree::GridPoint CellTree::to_grid(Uv uv) const {
  return clamped({(uv.u - domain_.u0) * lines_per_u_, (uv.v - domain_.v0) * lines_per_v_});
}

CellTree::GridPoint CellTree::clamped(GridPoint p) const {
  const double x = std::clamp(p.x, 0.0, double(end_i_)), y = std::clamp(p.y, 0.0, double(end_j_));
  return {is_triangle_ ? std::min(x, end_j_ - y) : x, y};
}

bool CellTree::contains(const Cell& c, GridPoint p) const {
  return p.x >= c.i0 && p.x <= c.i1 && p.y >= c.j0 && p.y <= c.j1;
}

int CellTree::root_at(GridPoint p) const {
  // A point on a line between roots belongs to the lower one: beyond a diagonal there is nothing.
  const auto index = [this](double x, int count) {
    const double from_lower = x / root_size_;
    const int root = static_cast<int>(from_lower);
    return std::min(root > 0 && root == from_lower ? root - 1 : root, count - 1);
  };
  return index(p.y, roots_.v) * roots_.u + index(p.x, roots_.u);
}

int CellTree::find(GridPoint p, int near) const {
  const bool is_near = static_cast<std::size_t>(near) < cells_.size() && contains(cell(near), p) &&
                       !is_empty(cell(near));
  int found = is_near ? near : root_at(p);
  while (!cell(found).is_leaf()) {
    const Cell& c = cell(found);
    const bool is_upper = c.is_halved_along_u ? p.x > middle(c.i0, c.i1) : p.y > middle(c.j0, c.j1);
    found = c.first_half + (is_upper ? 1 : 0);
  }
  return found;
}

std::array<int, 4> CellTree::leaves_around(Uv uv) const {
  constexpr double kStep = 0.5;  // cells are at least one grid line wide
  const GridPoint p = to_grid(uv);
  std::array<int, 4> leaves;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = p.x + (k % 2 == 0 ? -kStep : kStep), y = p.y + (k < 2 ? -kStep : kStep);
    leaves[k] = find(clamped({x, y}), -1);
  }
  return leaves;
}

CellTree::Quarter CellTree::quarter(Uv uv, int near) const {
  const GridPoint p = to_grid(uv);
  const int leaf = find(p, near);
  const Cell& c = cell(leaf);
  const double x = 2 * (p.x - c.i0) / (c.i1 - c.i0), y = 2 * (p.y - c.j0) / (c.j1 - c.j0);
  const std::size_t column = x > 1 ? 1 : 0, row = y > 1 ? 1 : 0;
  const std::size_t first = kLattice * row + column;
  return {leaf,
          {c.nodes[first], c.nodes[first + 1], c.nodes[first + 4], c.nodes[first + 3]},
          std::clamp(x - static_cast<double>(column), 0.0, 1.0),
          std::clamp(y - static_cast<double>(row), 0.0, 1.0)};
}

Uv CellTree::at(const Cell& c, double s, double t) const {
  return domain_.at((c.i0 + s * (c.i1 - c.i0)) / end_i_, (c.j0 + t * (c.j1 - c.j0)) / end_j_);
}

Uv CellTree::extent(const Cell& c) const {
  return {(c.i1 - c.i0) / lines_per_u_, (c.j1 - c.j0) / lines_per_v_};
}

// --- sides and faces ---

/// The nodes on a line through corners of roots: from the first corner, so many steps.
std::vector<int> CellTree::nodes_on_line(GridLine line) const {
  std::vector<int> nodes = {crossings_.at(key_of(line.i, line.j))};
  for (int k = 0; k < line.count; ++k) {
    const std::uint64_t from = key_of(line.i, line.j);
    line.i += line.step_i;
    line.j += line.step_j;
    const std::uint64_t to = key_of(line.i, line.j);
    add_hanging(from, to, nodes);
    nodes.push_back(crossings_.at(to));
  }
  return nodes;
}

std::vector<int> CellTree::nodes_on_side(bool along_u, bool is_upper) const {
  if (along_u) return nodes_on_line({0, is_upper ? end_j_ : 0, root_size_, 0, roots_.u});
  return nodes_on_line({is_upper ? end_i_ : 0, 0, 0, root_size_, roots_.v});
}

std::vector<int> CellTree::nodes_on_diagonal() const {
  // Unsigned arithmetic is modulo 2^32: adding this subtracts the size of a root.
  return nodes_on_line({end_i_, 0, 0u - root_size_, root_size_, roots_.u});
}

/// Add the nodes between two crossings of one line. Each lies halfway between two others.
void CellTree::add_hanging(std::uint64_t from, std::uint64_t to, std::vector<int>& corners) const {
  const auto half = [](std::uint32_t a, std::uint32_t b) { return (a + b) / 2; };
  const auto i0 = static_cast<std::uint32_t>(from >> 32), j0 = static_cast<std::uint32_t>(from);
  const auto i1 = static_cast<std::uint32_t>(to >> 32), j1 = static_cast<std::uint32_t>(to);
  const std::uint64_t between = key_of(half(i0, i1), half(j0, j1));
  if (between == from || between == to) return;
  const auto known = crossings_.find(between);
  if (known == crossings_.end()) return;
  add_hanging(from, between, corners);
  corners.push_back(known->second);
  add_hanging(between, to, corners);
}

std::vector<int> CellTree::hanging_nodes(int leaf, bool along_u) const {
  const Cell& c = cell(leaf);
  const Lines lines = lines_of(c);
  std::vector<int> nodes;
  for (const std::size_t side : {std::size_t{0}, kLattice - 1}) {
    for (std::size_t k = 0; k + 1 < kLattice; ++k) {
      const auto crossing = [&](std::size_t along) {
        return along_u ? lines.crossing(along, side) : lines.crossing(side, along);
      };
      add_hanging(crossing(k), crossing(k + 1), nodes);
    }
  }
  return nodes;
}

void CellTree::add_face(const Cell& c, std::size_t column, std::size_t row, FaceList& faces) const {
  const Lines lines = lines_of(c);
  const std::array<std::array<std::size_t, 2>, 4> around = {
      {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
  std::vector<int> corners;
  std::uint64_t last = 0;
  for (std::size_t k = 0; k <= around.size(); ++k) {
    const auto [x, y] = around[k % around.size()];
    if (c.node(x, y) < 0) continue;
    const std::uint64_t here = lines.crossing(x, y);
    if (!corners.empty()) add_hanging(last, here, corners);
    if (k < around.size()) corners.push_back(c.node(x, y));
    last = here;
  }
  if (corners.size() > 2) faces.add(corners);
}

FaceList CellTree::faces() const {
  FaceList faces;
  for (const Cell& c : cells_) {
    if (!c.is_leaf() || is_empty(c)) continue;
    for (std::size_t row = 0; row + 1 < kLattice; ++row) {
      for (std::size_t column = 0; column + 1 < kLattice; ++column) {
        add_face(c, column, row, faces);
      }
    }
  }
  return faces;
}

}  // namespace surfmesh
