// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/matched_sides.hh"

#include <fmt/format.h>

#include <utility>

namespace surfmesh {

std::string MatchedSides::name_of(const MatchedCurve& curve) const {
  for (const MatchedPiece& matched : curve.pieces) {
    if (piece(matched).is_whole) return side_of(matched).name;
  }
  const MatchedPiece& first = curve.pieces.front();
  return fmt::format("{}#{}", side_of(first).name, piece(first).part);
}

MatchedSides match_sides(std::vector<PatchSide> sides, const JoinLengths& lengths) {
  MatchedSides result{std::move(sides), {}, {}};
  result.split = split_sides(result.sides, lengths.join);
  result.curves = match_pieces(result.sides, result.split.pieces, lengths);
  return result;
}

}  // namespace surfmesh
