// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// Cells shorter than this share of the elements wanted there need not be finer: elements cannot
/// follow finer detail.
inline constexpr double kLeastCellLength = 0.3;

/// How control nodes are placed.
struct ControlNodeOptions {
  /// Number of regular nodes in the bounding rectangle, made square (40,000 is 200 × 200); 0
  /// chooses them by precision. 0, or 4 to 4,000,000.
  int regular = 0;
  /// Greatest conformity (max |ln λ|, DESIGN terms) between the exact field and one interpolated
  /// within a cell from its corners. Above 0.
  double precision = 0.1;
  /// True for nodes whose sizes are averaged by inverse distances (V_s, V_t, V_o), of first order
  /// only; false for linear interpolation, which needs far fewer.
  bool by_distance = false;
};

void check(const ControlNodeOptions& options);

struct ChosenNodes {
  std::vector<ControlNode> nodes;
  /// True if the field changes so fast that the nodes were cut off before they held the precision.
  bool is_coarse = false;
};

/// Place nodes so that the field is represented to a precision: at the corners of cells that are
/// halved until they conform (detail::ControlCells), or regularly.
///
/// The corners of the domain are always nodes, no position comes twice.
///
/// Cost     about twenty samples of the field a node
/// Throws   InvalidOption
ChosenNodes choose_control_nodes(const SizeField& field, const ControlNodeOptions& options);

}  // namespace surfmesh
