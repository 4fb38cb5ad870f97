// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh::detail {

/// Cells that cover a domain, and control nodes at their corners.
///
/// A cell whose corners do not give the sizes within it is halved, across the direction in which
/// there is most to mend, unless it is small in that direction against the elements wanted there.
/// It is sampled at irrational shares, so that a periodic field cannot hide between nodes, and at
/// the points of sources. What it has been found to miss is kept: a finer precision takes up the
/// cells where they are, and samples new ones only.
///
/// From 20,000 nodes and 16 a unit of metric area on (more by distance with a small precision),
/// four million at most, no cell is halved any more: elements cannot follow.
class NodeCells {
 public:
  /// The field must outlive the cells. `by_distance` as in ControlNodeOptions.
  NodeCells(const SizeField& field, bool by_distance);

  /// Halve cells until all of them conform to the precision. Returns whether they do, or are as
  /// fine as elements can follow; false if there were too many.
  ///
  /// Cost     ten samples of the field a cell that is made
  /// Pre      precision above 0
  bool refine(double precision);

  /// The nodes, each with the spacing of the finest cell that it is a corner of.
  std::vector<ControlNode> nodes() const;

 private:
  /// How a cell is to be halved, and the conformity that it misses before.
  struct Halving {
    double error = 0;
    bool is_along_u = false;
  };

  /// Intervals of grid lines. Corners count around from the lower left one.
  struct Cell {
    std::uint32_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
    std::array<std::size_t, 4> corners = {};
    std::vector<std::size_t> points = {};  ///< those of sources inside
    double metric_area = 0;
    Halving halving = {};
  };

  /// By the rows and columns of samples in one cell, rows along u.
  template <class Value>
  using Table = std::array<std::array<Value, 3>, 3>;

  struct CellSamples {
    Table<Uv> at;
    Table<SizeField::Sample> field;
  };

  Uv at(double i, double j) const;
  Uv extent(const Cell& cell) const;
  std::size_t node(std::uint32_t i, std::uint32_t j);
  void examine(Cell& cell);
  CellSamples sample(const Cell& cell) const;
  void measure(Cell& cell, const CellSamples& samples);
  Halving halving_by_samples(const Cell& cell, const CellSamples& samples) const;
  Halving halving_by_points(const Cell& cell) const;
  double error_at(const Cell& cell, Uv uv, const SizeField::Sample& exact) const;
  double change(const Table<double>& errors, const CellSamples& samples, bool along_u) const;
  void halve(const Cell& cell, std::deque<Cell>& cells);
  void add_points(Cell& cell, const std::vector<std::size_t>& points) const;
  bool is_full(double precision) const;

  const SizeField& field_;
  Domain domain_;
  bool by_distance_;
  std::vector<SizeField::Sample> points_;  ///< the field at its points
  std::vector<Cell> cells_;
  std::vector<ControlNode> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> index_;
  double metric_area_ = 0;  ///< of all cells
};

}  // namespace surfmesh::detail
