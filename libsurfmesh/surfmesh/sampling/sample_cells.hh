// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/control/control_cells.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// How well a control space represents the sizes of its sources, on a sample of points that played
/// no part in its choice of nodes.
struct PrecisionSample {
  double asked = 0;     ///< greatest conformity that is wanted
  std::size_t points = 0;
  std::size_t over = 0;  ///< points that miss more
  double greatest = 0;   ///< miss of all points

  double share_over() const {
    return points > 0 ? static_cast<double>(over) / static_cast<double>(points) : 0;
  }

  /// Take in the sample of another patch.
  PrecisionSample& operator+=(const PrecisionSample& other);
  friend bool operator==(const PrecisionSample&, const PrecisionSample&) = default;
};

struct CellSampling {
  PrecisionSample precision;
  /// True if the field changes so fast that cells were no longer halved.
  bool is_coarse = false;
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
/// Error    DECISIONS.md, sampling
/// Cost     1.5 samples of the field per node, about 1 µs per node besides
/// Throws   Cancelled; InvalidInput if a field is not positive and finite
CellSampling sample_cells(const SizeField& field, ControlCells& cells, double precision,
                          const RunContext& context);

}  // namespace surfmesh
