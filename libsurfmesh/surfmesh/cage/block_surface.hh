// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/cage/cage_surface.hh"

namespace surfmesh {

/// A surface over the unit square as a cell of a block, and how it is turned there.
struct BlockCell {
  std::shared_ptr<const Surface> surface;
  int rotation = 0;  ///< 0 to 3: the corner of its domain at the lower left of the cell
};

/// Surfaces side by side in a rectangle, as one surface over [0,columns] × [0,rows].
///
/// Each cell is a unit square. Derivatives are those of the cell, in the directions of the block;
/// on an edge between two cells, those of the right or upper one. Singular points and places on the
/// cage are those of the cells.
class BlockSurface : public CageSurface {
 public:
  /// Cells row by row from the bottom, each row from the left.
  ///
  /// Throws   InvalidInput if the cells do not form a rectangle, or if one is missing or not over
  ///          the unit square
  BlockSurface(int columns, std::vector<BlockCell> cells);

  /// Cost     that of the cell plus 5 ns, for any number of cells
  Jet evaluate(Uv uv, Order order) const override;

  /// The place that the cell tells; of no face where its surface is one of no cage.
  CagePlace place(Uv uv) const override;

  Domain domain() const override;
  CellCount cells() const override { return {columns_, rows_}; }
  std::vector<SingularPoint> singular_points() const override;
  Uv beside_roundings(Uv uv) const override;

 private:
  struct CellPoint {
    const BlockCell& cell;
    Uv corner;  ///< its lower left
  };

  CellPoint find_cell(Uv uv) const;

  int columns_;
  int rows_;
  std::vector<BlockCell> cells_;
};

}  // namespace surfmesh
