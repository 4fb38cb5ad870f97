// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/control/control_nodes.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Keep few of many nodes so that the sizes of the others follow from those kept.
///
/// Begins with the nodes nearest to the corners of the rectangle and adds, in rounds, from each
/// triangle the node that is represented worst, until all nodes left out conform to the precision
/// (log_conformity) with the interpolation of those kept. Nodes that come so near to one kept that
/// a control space would merge them are kept at most once more.
///
/// Returns  the nodes kept, in their order
/// Cost     about log(n) rounds, each a control space of the nodes kept so far and a query of every
///          other node: about 5 µs a node in all
/// Pre      precision above 0
/// Source   paper, section 6: the choice of nodes that it leaves open
std::vector<ControlNode> thin_nodes(const Surface& surface, const std::vector<ControlNode>& nodes,
                                    double precision);

}  // namespace surfmesh
