// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/proximity.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/sizes/boundary_pieces.hh"

namespace surfmesh {
namespace {

using detail::BoundaryPiece;
using detail::BoundaryPieces;
using detail::BoundaryPoint;

/// Cosine of the greatest angle between the way across and an inward direction, and of the least
/// angle, negated, between two inward directions that face each other.
constexpr double kFacing = 0.5;

/// Longest piece in gaps.
constexpr double kLongestPiece = 2;

/// Halvings of one chord.
constexpr int kMaxGapHalvings = 12;

/// Distance of chords from contours as a share of hmax, where no gap asks for less.
constexpr double kGapChordShare = 0.02;

/// Ratio of the size along the boundary to that across the gap.
constexpr double kAlong = 2;

/// Height of the unit triangle: a row of elements takes so much of a gap, in sizes across it. With
/// the size as the height a row would be of squares, whose diagonals √2 are on the verge of being
/// split: some gaps would get twice the elements of others, and three rows would always be four.
constexpr double kRowHeight = std::numbers::sqrt3 / 2;

class GapSearch {
 public:
  /// Adds to `sizes`, by patch.
  GapSearch(const Model& model, const std::vector<int>& patches, const ResolvedSizing& sizing,
            std::vector<std::vector<PlacedSize>>& sizes)
      : bounds_(sizing.bounds),
        rows_height_(sizing.proximity * kRowHeight),
        pieces_(model, patches, kGapChordShare * sizing.bounds.hmax,
                rows_height_ * sizing.bounds.hmin, rows_height_ * sizing.bounds.hmax),
        sizes_(sizes) {}

  void run() {
    for (const BoundaryPiece& piece : pieces_.all()) cross(piece, 0);
  }

 private:
  bool are_facing(const BoundaryPiece& piece, const BoundaryPoint& point) const {
    const Vec3& inward = pieces_[point.piece].inward;
    const Vec3 step = point.point - piece.middle;
    return piece.inward.dot(inward) <= -kFacing &&
           step.dot(piece.inward) >= kFacing * point.distance &&
           -step.dot(inward) >= kFacing * point.distance && !pieces_.are_joined(piece, point);
  }

  /// Add the size across from the middle of a piece, or from finer pieces.
  void cross(const BoundaryPiece& piece, int depth) {
    const auto opposite =
        pieces_.nearest(piece.middle, {piece.inward, -kFacing, kFacing},
                        [&](const BoundaryPoint& point) { return are_facing(piece, point); });
    if (!opposite) return;
    const double least_seen = std::max(opposite->distance, rows_height_ * bounds_.hmin);
    if (piece.width() <= kLongestPiece * least_seen || depth == kMaxGapHalvings) {
      add(piece, *opposite);
      return;
    }
    for (const BoundaryPiece& half : pieces_.halves(piece)) cross(half, depth + 1);
  }

  void add(const BoundaryPiece& piece, const BoundaryPoint& opposite) {
    const double size = bounds_.clamp(opposite.distance / rows_height_);
    PlacedSize placed;
    placed.from = piece.middle;
    placed.to = opposite.point;
    placed.at_from = placed.at_to = {size, bounds_.clamp(kAlong * size)};
    placed.follows_segment = true;
    placed.radius = 0.5 * piece.width();
    const int other = pieces_[opposite.piece].patch;
    sizes_[static_cast<std::size_t>(piece.patch)].push_back(placed);
    if (other != piece.patch) sizes_[static_cast<std::size_t>(other)].push_back(placed);
  }

  const SizeBounds& bounds_;
  double rows_height_;  ///< gap that the elements asked for fill, in sizes across it
  BoundaryPieces pieces_;
  std::vector<std::vector<PlacedSize>>& sizes_;
};

/// The patches that smooth contours join, in the order of the first of each group.
std::vector<std::vector<int>> smooth_groups(const Model& model) {
  DisjointSets sets(model.patches.size());
  for (const Contour& contour : model.contours) {
    if (!contour.is_smooth || contour.uses.empty()) continue;
    for (const ContourUse& use : contour.uses) {
      sets.unite(static_cast<std::size_t>(contour.uses.front().patch),
                 static_cast<std::size_t>(use.patch));
    }
  }
  std::vector<std::vector<int>> groups;
  std::vector<std::size_t> group_of(model.patches.size());
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const std::size_t first = sets.find(p);  // the least of its set
    if (first == p) {
      group_of[p] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[first]].push_back(static_cast<int>(p));
  }
  return groups;
}

}  // namespace

std::vector<std::vector<PlacedSize>> proximity_sizes(const Model& model,
                                                     const ResolvedSizing& sizing) {
  std::vector<std::vector<PlacedSize>> sizes(model.patches.size());
  if (sizing.proximity == 0) return sizes;
  const auto groups = smooth_groups(model);
  share_indices(groups.size(),
                [&](std::size_t g) { GapSearch(model, groups[g], sizing, sizes).run(); });
  return sizes;
}

}  // namespace surfmesh
