// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/quad/root_frame.hh"

namespace surfmesh {

/// A node of the boundary and the quads that fit there.
struct BoundaryCorner {
  /// The direction of the side that leads on, in the root frame of the node.
  Direction ahead;
  double angle = 0;  ///< from there to the side that leads back, in the metric, in (0, 2π]
  int quads = 1;     ///< that fit best: the angle in quarter turns, rounded, at least 1
};

/// The corners at the nodes of the loops, which are the first vertices of a mesh, one loop after
/// the other, with the interior on the left.
///
/// Reads    surf:uv, surf:metric (vertex)
/// Cost     O(nodes)
std::vector<BoundaryCorner> boundary_corners(const PolyMesh& mesh,
                                             std::span<const std::size_t> loop_sizes);

}  // namespace surfmesh
