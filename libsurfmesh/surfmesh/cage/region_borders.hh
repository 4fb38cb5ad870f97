// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/face_loops.hh"
#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/cage/gather_regions.hh"

namespace surfmesh {

/// Edges of the cage between two regions, or at the border of one, from a place where others meet
/// to the next.
struct BorderChain {
  /// As one of the regions passes them, in its direction.
  struct Use {
    int region = -1;
    bool is_forward = true;                   ///< the region passes the sides in the chain's order
    std::vector<FaceNeighbours::Side> sides;  ///< in the order of the chain
  };

  int start = -1;         ///< vertex of the cage
  int second = -1;        ///< likewise, where the first edge ends
  int end = -1;           ///< likewise; the start again for a closed chain
  bool is_smooth = true;  ///< the surface is smooth across
  /// True if it is where it is only because the regions are: it may run elsewhere between its ends.
  bool is_free = false;
  std::vector<Use> uses;

  int edge_count() const { return static_cast<int>(uses[0].sides.size()); }
};

/// A use of a chain in a loop of a region.
struct ChainUse {
  int chain = -1;
  int use = -1;
};

/// How regions lie beside each other.
struct RegionBorders {
  std::vector<BorderChain> chains;
  std::vector<std::vector<std::vector<ChainUse>>> loops;  ///< by region, counter-clockwise
};

/// Find the chains between regions, and how they bound these.
///
/// Chains end where not just two border edges meet, at corners, where creases begin, where faces
/// left out of the cage leave a corner, and at the corners of single faces. So that a loop
/// has three chains at least, and none that is closed but for those of two edges, they also end in
/// between.
/// Cost     O(faces)
RegionBorders find_borders(const FaceNeighbours& neighbours,
                           const std::vector<FaceRegion>& regions);

}  // namespace surfmesh
