// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Open edges of a cage that lie on other edges, but have vertices of their own.
struct OpenSeams {
  std::size_t edges = 0;                ///< that are open and lie on others
  std::array<int, 2> first = {-1, -1};  ///< vertices of the first of them
  double gap = 0;                       ///< greatest distance of their vertices, in model units
};

/// Find the open edges whose two ends are both near those of another edge.
///
/// Near is within 1e-4 of the cage's diagonal and a tenth of its shortest open edge, but at least
/// within `least`.
/// Cost     O(n log n) for n face corners; only what counts edges if no edge is open
OpenSeams find_open_seams(const Cage& cage, double least);

}  // namespace surfmesh
