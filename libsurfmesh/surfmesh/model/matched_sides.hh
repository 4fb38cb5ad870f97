// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/model/match_pieces.hh"
#include "surfmesh/model/patch_sides.hh"
#include "surfmesh/model/split_sides.hh"

namespace surfmesh {

/// Sides, their pieces and the curves that these make.
struct MatchedSides {
  std::vector<PatchSide> sides;
  SplitSides split;
  std::vector<MatchedCurve> curves;

  const SidePiece& piece(const MatchedPiece& matched) const {
    return split.pieces[static_cast<std::size_t>(matched.piece)];
  }
  const PatchSide& side_of(const MatchedPiece& matched) const {
    return sides[static_cast<std::size_t>(piece(matched).side)];
  }
  const SidePiece& front_of(const MatchedCurve& curve) const { return piece(curve.pieces.front()); }
  bool is_degenerate(const MatchedCurve& curve) const {
    return side_of(curve.pieces.front()).is_degenerate;
  }

  /// The first whole side among the pieces, else the first piece's side with its part.
  std::string name_of(const MatchedCurve& curve) const;
};

/// Divide sides at vertices, and find the pieces that coincide.
MatchedSides match_sides(std::vector<PatchSide> sides, const JoinLengths& lengths);

}  // namespace surfmesh
