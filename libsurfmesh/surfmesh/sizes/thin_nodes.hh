// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Keep a few of many nodes, such that the sizes of the others follow from those kept.
///
/// First, nodes at exactly the same point become one, with the minimum of their sizes. The search
/// starts from the nodes nearest to the corners of the rectangle. In each round it adds the worst
/// represented node of each triangle; after twenty rounds it adds all nodes that miss the
/// precision. It ends when all nodes left out conform to the precision (log_conformity) with the
/// interpolation of those kept.
///
/// Returns  the nodes kept, in the order of the first node at each point
/// Cost     O(n log n) per round: a control space of the nodes kept so far, and a query for every
///          other node. A smooth field takes about log(n) rounds and 5 µs per node in total; noise
///          takes a few more than twenty rounds
/// Pre      precision above 0
/// Source   paper, section 6: the choice of nodes that it leaves open
std::vector<ControlNode> thin_nodes(const Surface& surface, const std::vector<ControlNode>& nodes,
                                    double precision);

}  // namespace surfmesh
