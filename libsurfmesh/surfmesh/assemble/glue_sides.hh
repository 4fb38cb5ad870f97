// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surfmesh/assemble/piece.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// Which sides of faces become one edge.
struct GluedSides {
  /// The sides of each edge; the second one is -1 where it is left open.
  std::vector<std::array<int, 2>> edges;
  std::size_t side_count = 0;
  std::size_t cut = 0;  ///< sides left open although others have their vertices
};

/// Glue sides that have the same two vertices: those of patches that joined_uses names where three
/// and more meet, and otherwise two that lead opposite ways, if there is no third one.
///
/// Edges are ordered by their vertices. Nothing is joined along `cut_contours`, but by the second
/// rule.
///
/// Cost     O(n log n); for models with contours of three and more patches also joined_uses
GluedSides glue_sides(const std::vector<BorderSide>& sides, const Model& model,
                      const std::vector<int>& cut_contours);

}  // namespace surfmesh::detail
