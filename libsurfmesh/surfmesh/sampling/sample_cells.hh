// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/control/control_cells.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// How well a control space represents the sizes of its sources before gradation, on a sample of
/// points that played no part in its choice of nodes.
struct PrecisionSample {
  double asked = 0;  ///< greatest conformity that is wanted, the least of several patches
  std::size_t points = 0;
  std::size_t over = 0;  ///< points that miss more, in cells that elements can follow
  double greatest = 0;   ///< miss of all points in such cells
  std::size_t over_in_short_cells = 0;  ///< other points that miss more
  double greatest_in_short_cells = 0;

  double share_over() const {
    return points > 0 ? static_cast<double>(over) / static_cast<double>(points) : 0;
  }

  /// True if 2 % of the points or fewer miss the precision, in cells that elements can follow, or
  /// as many more as chance explains.
  bool is_held() const;

  /// Take in the sample of another patch.
  PrecisionSample& operator+=(const PrecisionSample& other);
  friend bool operator==(const PrecisionSample&, const PrecisionSample&) = default;
};

/// Compare a lattice with the field at quasi-random points: one for each twenty nodes, eight at
/// least. Cells shorter than `short_units` elements are those that elements cannot follow.
/// Throws   Cancelled
PrecisionSample sample_precision(const SizeField& field, const LatticeSpace& space,
                                 double precision, double short_units,
                                 const RunContext& context = RunContext());

/// How well cells represent a field at the end of their halving.
struct CellSampling {
  PrecisionSample precision;
  /// True if the field changes so fast that cells were no longer halved.
  bool is_coarse = false;
  bool is_search_incomplete = false;  ///< the budget of FieldSearch was spent
};

/// Cells that a field starts with: those of the surface, at least two along each side.
CellCount first_cells(const Surface& surface);

/// Halve cells until they represent the field to a precision.
///
/// A cell is halved while its nodes bend too far from linear, or where a point inside, at an
/// irrational share of its sides, or a required point of the field misses the precision. Cells are
/// not halved in a direction in which they are shorter than two elements; with a precision below
/// 0.1, than fewer. From 20,000 nodes and 16 per unit of metric area on, four million at most,
/// elements cannot follow, and no cell is halved any more.
///
/// Required points that the cells of the least length do not give become points of their own
/// (LatticeSpace::hold_points). Fields of the user are searched beyond these points (FieldSearch,
/// find_hidden).
///
/// Error    DECISIONS.md, sampling; test SampleCells.*
/// Cost     1.2 to 1.8 samples of the field per node, 0.8 µs in all on a wave (halve_cells in
///          tests/bench/control_bench.cc), beside the search
/// Throws   Cancelled; InvalidInput if a field is not positive and finite
CellSampling sample_cells(const SizeField& field, ControlCells& cells, double precision,
                          const RunContext& context);

}  // namespace surfmesh
