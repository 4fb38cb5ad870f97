// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/geometry/curve_polyline.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/piece_tree.hh"

/// The boundary of some patches in pieces, to be searched for those that face each other.
namespace surfmesh::detail {

/// A part of a contour use, and its chord.
struct BoundaryPiece {
  int contour = -1;
  int use = -1;
  int patch = -1;
  double t0 = 0, t1 = 0;
  Vec3 from, to;
  Vec3 middle;            ///< of the contour, at the mean of t0 and t1
  Vec3 inward;            ///< unit vector at the middle, in the tangent plane
  double sag = 0;         ///< greatest distance of the contour from the chord, at three places
  double way = 0;         ///< along the contour from its start to the middle
  double way_length = 0;  ///< of the piece along the contour
  double whole = 0;       ///< length of the whole contour

  double width() const { return (to - from).norm(); }
};

/// A point on the chord of a piece.
struct BoundaryPoint {
  int piece = -1;
  double share = 0;  ///< of the way along the chord
  Vec3 point = Vec3::Zero();
  double distance = 0;  ///< from the point that it was looked for from
};

/// The contours of some patches that are not smooth, in pieces that are straight as seen from the
/// other side of a gap: nearer to their chords than a twentieth of the distance to the piece that
/// is nearest opposite of their middle, or of the least gap; after 12 rounds they are taken as they
/// are.
class BoundaryPieces {
 public:
  /// True if a point of a piece may be an answer.
  using Accepts = std::function<bool(const BoundaryPoint&)>;

  /// Units    tolerance (distance of chords where nothing is near), the least gap that matters, and
  ///          the reach, within which pieces are opposite, in model units
  /// Cost     five evaluations a piece, and O(n log n) for n pieces in up to 12 rounds
  BoundaryPieces(const Model& model, const std::vector<int>& patches, double tolerance,
                 double least_gap, double reach);

  const std::vector<BoundaryPiece>& all() const { return pieces_; }
  const BoundaryPiece& operator[](int piece) const {
    return pieces_[static_cast<std::size_t>(piece)];
  }

  /// The halves of a piece; a half without a tangent plane at its middle is left out.
  std::vector<BoundaryPiece> halves(const BoundaryPiece& piece) const;

  /// The point of a piece nearest to p and within reach of those that face p as asked and are
  /// accepted. A piece that does not face p may or may not be offered.
  ///
  /// Cost     O(log n), and O(1) for each piece offered
  std::optional<BoundaryPoint> nearest(const Vec3& p, const Facing& facing,
                                       const Accepts& accepts) const;

  /// True if the boundary leads from the middle of a piece to a point by a way of no more than six
  /// times its distance: around a corner or a bend, that is, along one contour or two that end at
  /// one vertex. Also true at the same place, for where sides coincide that are not joined is no
  /// gap; and for contours that leave a vertex in the same direction.
  bool are_joined(const BoundaryPiece& piece, const BoundaryPoint& point) const;

 private:
  bool complete(BoundaryPiece& piece) const;
  void collect(int patch, double tolerance);
  void collect(int patch, const LoopEntry& entry, double tolerance);
  void plant_tree();
  void straighten();
  std::vector<char> find_bent() const;
  bool are_in_cusp(const BoundaryPiece& piece, const BoundaryPoint& point) const;
  double way_between(const BoundaryPiece& piece, const BoundaryPoint& point) const;

  const Model& model_;
  double least_gap_;
  double reach_;
  std::vector<BoundaryPiece> pieces_;
  PieceTree tree_;
};

}  // namespace surfmesh::detail
