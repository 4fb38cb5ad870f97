// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Keep few of many nodes so that the sizes of the others follow from those kept.
///
/// Nodes at exactly one place first become one, with the minimum of their sizes. Begins with the
/// nodes nearest to the corners of the rectangle and adds, in rounds, from each triangle the node
/// that is represented worst; after twenty rounds all that are. Ends when all nodes left out
/// conform to the precision (log_conformity) with the interpolation of those kept.
///
/// Returns  the nodes kept, in the order of the first at their places
/// Cost     O(n log n) a round, each a control space of the nodes kept so far and a query of every
///          other node: for a smooth field about log(n) rounds and 5 µs a node in all, for noise
///          few more than twenty
/// Pre      precision above 0
/// Source   paper, section 6: the choice of nodes that it leaves open
std::vector<ControlNode> thin_nodes(const Surface& surface, const std::vector<ControlNode>& nodes,
                                    double precision);

}  // namespace surfmesh
