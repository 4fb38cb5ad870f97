// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/domain.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Cells that cover a domain, each with a lattice of 3 × 3 nodes. A cell is halved along u or v;
/// its halves share the nodes of its lattice, and neighbours share those on their common side.
///
/// The cells are a binary tree below a grid of roots; its leaves are the cells in use. In a
/// triangular domain, cells on the diagonal are square and are cut by it from corner to corner.
/// Nodes and leaves beyond the diagonal do not exist.
class CellTree {
 public:
  static constexpr std::size_t kLattice = 3;  ///< nodes along each side of a cell

  /// Makes a node at a point and returns its number: 0, 1, 2, …
  using MakeNode = std::function<int(Uv)>;

  /// An interval of grid lines. Coordinates are integers, so that neighbours share nodes exactly.
  struct Cell {
    std::uint32_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
    int first_half = -1;  ///< of a halved cell: its lower half; the upper one is the next cell
    bool is_halved_along_u = false;
    /// Rows along u from the lower left corner; -1 for nodes that do not exist.
    std::array<int, kLattice* kLattice> nodes = {};

    bool is_leaf() const { return first_half < 0; }
    int node(std::size_t column, std::size_t row) const { return nodes[kLattice * row + column]; }
  };

  /// One of the four parts of a leaf between its nodes, and a point in it.
  struct Quarter {
    int leaf;
    /// Counter-clockwise from the lower left one; the third is -1 where the diagonal cuts it off.
    std::array<int, 4> nodes;
    double s;  ///< of the point, in [0,1] along u
    double t;  ///< likewise along v

    /// Shares of the nodes in a bilinear interpolation; linear in a quarter that is cut.
    std::array<double, 4> weights() const;
  };

  /// Start with a grid of cells; in a triangular domain, as many along v as along u.
  CellTree(const Domain& domain, CellCount roots, const MakeNode& make_node);

  /// Halve a leaf; one on the diagonal of a triangular domain is halved in both directions.
  /// Pre      can_halve()
  void halve(int leaf, bool along_u, const MakeNode& make_node);

  /// False if a leaf is a few grid lines wide.
  bool can_halve(int leaf, bool along_u) const;

  std::size_t size() const { return cells_.size(); }
  const Cell& cell(int index) const { return cells_[static_cast<std::size_t>(index)]; }

  /// True for a leaf without any node, beyond the diagonal.
  bool is_empty(const Cell& cell) const { return cell.nodes[0] < 0 && cell.is_leaf(); }

  /// True if the diagonal of a triangular domain cuts a cell.
  bool is_cut(const Cell& cell) const;

  /// The leaf that contains a point; a point outside the domain is moved to its rim. Fast if that
  /// is the leaf `near`, or below the cell `near`.
  ///
  int find(Uv uv, int near = -1) const { return find(to_grid(uv), near); }

  /// The quarter that contains a point, likewise.
  Quarter quarter(Uv uv, int near) const;

  /// The leaves beside a point in the four diagonal directions; one may be there several times.
  std::array<int, 4> leaves_around(Uv uv) const;

  /// The point at relative coordinates in a cell, each in [0,1].
  Uv at(const Cell& cell, double s, double t) const;

  /// Width and height of a cell in parameters.
  Uv extent(const Cell& cell) const;

  /// The leaves that have a node in their lattice; -1 for fewer than four.
  const std::array<int, 4>& leaves_of(int node) const {
    return leaves_of_[static_cast<std::size_t>(node)];
  }

  /// Announce a node that belongs to no lattice.
  void add_loose_node() { leaves_of_.push_back(kNoLeaves); }

  /// The nodes on a line of constant v (`along_u`) or u through the domain, from the lower end.
  std::vector<int> nodes_on_side(bool along_u, bool is_upper) const;

  /// The nodes on the diagonal of a triangular domain, from the lower right end.
  std::vector<int> nodes_on_diagonal() const;

  /// The nodes of finer neighbours on the sides of a leaf along u or v that are none of its own.
  std::vector<int> hanging_nodes(int leaf, bool along_u) const;

  /// The quarters of all leaves as polygons, in the order of the leaves. A node of a finer
  /// neighbour on a side is a further corner.
  FaceList faces() const;

 private:
  static constexpr std::array<int, 4> kNoLeaves = {-1, -1, -1, -1};

  /// Coordinates in grid lines.
  struct GridPoint {
    double x;
    double y;
  };

  /// A line through corners of roots.
  struct GridLine {
    std::uint32_t i, j;  ///< where it starts
    std::uint32_t step_i, step_j;
    int count;  ///< of steps
  };

  /// Grid lines through the nodes of a cell.
  struct Lines {
    std::array<std::uint32_t, kLattice> i;
    std::array<std::uint32_t, kLattice> j;

    std::uint64_t crossing(std::size_t column, std::size_t row) const {
      return std::uint64_t{i[column]} << 32 | j[row];
    }
  };

  static Lines lines_of(const Cell& cell);
  GridPoint to_grid(Uv uv) const;
  GridPoint clamped(GridPoint p) const;
  int find(GridPoint p, int near) const;
  bool contains(const Cell& cell, GridPoint p) const;
  int root_at(GridPoint p) const;
  int make_crossing(std::uint32_t i, std::uint32_t j, const MakeNode& make_node);
  bool is_beyond_diagonal(std::uint32_t i, std::uint32_t j) const;
  void make_lattice(int index, const MakeNode& make_node);
  void split(int index, bool along_u);
  void replace_leaf(int node, int old_leaf, int new_leaf);
  void forget_leaf(int index);
  void add_hanging(std::uint64_t from, std::uint64_t to, std::vector<int>& corners) const;
  void add_face(const Cell& cell, std::size_t column, std::size_t row, FaceList& faces) const;
  std::vector<int> nodes_on_line(GridLine line) const;

  Domain domain_;
  CellCount roots_;
  std::uint32_t root_size_;  ///< grid lines along a root
  double lines_per_u_;
  double lines_per_v_;
  std::uint32_t end_i_;
  std::uint32_t end_j_;
  bool is_triangle_;
  std::vector<Cell> cells_;
  std::vector<std::array<int, 4>> leaves_of_;         ///< by node
  std::unordered_map<std::uint64_t, int> crossings_;  ///< nodes by grid lines
};

}  // namespace surfmesh
