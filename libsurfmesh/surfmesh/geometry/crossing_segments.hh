// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// A closed chain of nodes in the parameters of a patch; the last is joined to the first.
using NodeLoop = std::vector<Uv>;

/// A segment of some loops, from its node to the next.
struct LoopSegment {
  std::size_t loop = 0;
  std::size_t node = 0;

  friend bool operator==(const LoopSegment&, const LoopSegment&) = default;
};

/// Pairs of segments that have a point in common and are not next to each other in a loop. A common
/// end alone, where loops touch in a node, does not count.
///
/// Exact. Coordinates must be finite.
/// Cost     O(n log n) for segments that are short against the loops
std::vector<std::pair<LoopSegment, LoopSegment>> crossing_segments(
    const std::vector<NodeLoop>& loops);

}  // namespace surfmesh::detail
