// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/split_sides.hh"

namespace surfmesh {

/// A piece of a side as one of those that coincide.
struct MatchedPiece {
  int piece = -1;
  bool is_reversed = false;  ///< it runs against the first of them
  bool is_same_speed = true;
};

/// Pieces that coincide, in their order; the first gives the direction.
struct MatchedCurve {
  std::vector<MatchedPiece> pieces;
  SampledLine first;  ///< the first piece
};

/// Find the pieces that coincide in space up to JoinLengths::join.
///
/// Pieces coincide if they have the same end vertices and all samples of each are on the other.
/// Degenerate sides coincide with nothing. Pieces of one patch that are no longer than
/// JoinLengths::near coincide only if they are whole sides: in its corners, sides are near to each
/// other without being a seam.
///
/// Returns  the curves in the order of their first pieces
/// Cost     O(n log n) for n pieces, and O(k²) comparisons of boxes for k pieces that differ but
///          have the same ends
std::vector<MatchedCurve> match_pieces(const std::vector<PatchSide>& sides,
                                       const std::vector<SidePiece>& pieces,
                                       const JoinLengths& lengths);

}  // namespace surfmesh
