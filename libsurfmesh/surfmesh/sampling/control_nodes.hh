// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/sizes/size_field.hh"

namespace surfmesh {

/// Cells shorter than this share of the elements wanted there need no further halving: elements
/// cannot follow finer detail.
inline constexpr double kLeastCellLength = 0.3;

/// Nodes for sizes of a metric area from which on no finer ones are chosen, for elements cannot
/// follow: 16 per unit, of which an element takes 0.43, and 20,000 beside these. Smooth fields take
/// less than one per unit, creased patches of a few elements hundreds in all.
inline double most_nodes(double metric_area) { return 20'000 + 16 * metric_area; }

/// How control nodes are chosen.
struct ControlNodeOptions {
  /// Number of regular nodes in the bounding rectangle, as a square (40,000 is 200 × 200). 0: nodes
  /// are chosen by precision. 0, or 4 to 4,000,000.
  int regular = 0;
  /// Greatest conformity (max |ln λ|) between the exact field and the one interpolated within a
  /// cell from its corners. Above 0.
  double precision = 0.1;
  /// True for nodes whose sizes are averaged by inverse distances (V_s, V_t, V_o), which is of
  /// first order only; false for linear interpolation, which needs far fewer nodes.
  bool by_distance = false;
};

/// Throws   InvalidOption, naming the option, its value and its range
void check(const ControlNodeOptions& options);

/// The nodes of a control space.
struct ChosenNodes {
  std::vector<ControlNode> nodes;
  /// True if the field changes so fast that nodes were cut off before the precision was reached.
  bool is_coarse = false;
};

/// Choose nodes that represent the field to a precision: the corners of cells that are halved until
/// they conform (detail::NodeCells), or regular ones.
///
/// The corners of the domain are always nodes. No two nodes have the same position.
///
/// Cost     about twenty samples of the field per node
/// Throws   InvalidOption
ChosenNodes choose_control_nodes(const SizeField& field, const ControlNodeOptions& options);

}  // namespace surfmesh
