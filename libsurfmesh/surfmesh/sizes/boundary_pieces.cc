// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/boundary_pieces.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "surfmesh/core/at_location.hh"

namespace surfmesh::detail {
namespace {

/// Distance of a chord from its contour as a share of the gap on either side of it. Chords nearer
/// to each other than they are to their contours would lie on the wrong side of each other, and
/// the gap would be missed, or measured far too small.
constexpr double kSagShare = 0.05;

/// A way along the boundary that is no more than so many gaps is a corner or a bend, not a gap.
constexpr double kLeastWay = 6;

/// Points of a contour nearer to each other than this share of its length are one: it may bound the
/// patch on both sides.
constexpr double kSamePoint = 1e-9;

/// Contours that leave a vertex at less than about 5°, as seen at this share of them, make a cusp.
constexpr double kCornerShare = 1e-3;
constexpr double kCuspCosine = 0.996;

/// Rounds of halving: contours that touch have pieces that are never straight enough.
constexpr int kMaxRounds = 12;

double distance_from_chord(const BoundaryPiece& piece, const Vec3& p) {
  const double share = nearest_share(piece.from, piece.to, p);
  return (p - piece.from - share * (piece.to - piece.from)).norm();
}

/// Finds the nearest accepted point in a tree of pieces.
struct NearestPoint {
  using Scalar = double;  // which Eigen asks for

  const BoundaryPieces& pieces;
  const Vec3& p;
  const Facing& facing;
  const BoundaryPieces::Accepts& accepts;
  double least;  ///< at first the reach
  std::optional<BoundaryPoint> found = {};

  double minimumOnVolume(const PieceVolume& volume) const {
    const double distance = std::sqrt(volume.chords.squaredExteriorDistance(p));
    const bool is_near = distance < least && may_face(volume, facing, p);
    return is_near ? distance : std::numeric_limits<double>::infinity();
  }

  double minimumOnObject(int index) {
    const BoundaryPiece& piece = pieces[index];
    const double share = nearest_share(piece.from, piece.to, p);
    const Vec3 q = piece.from + share * (piece.to - piece.from);
    const BoundaryPoint point{index, share, q, (q - p).norm()};
    if (!(point.distance < least) || !accepts(point)) {
      return std::numeric_limits<double>::infinity();
    }
    least = point.distance;
    found = point;
    return least;
  }
};

}  // namespace

BoundaryPieces::BoundaryPieces(const Model& model, const std::vector<int>& patches,
                               double tolerance, double least_gap, double reach)
    : model_(model), least_gap_(least_gap), reach_(reach) {
  for (const int p : patches) {
    at_location(label(model.patch(p)), [&] { collect(p, tolerance); });
  }
  plant_tree();
  straighten();
}

/// Set what follows from the contour between the ends; false where there is no tangent plane.
bool BoundaryPieces::complete(BoundaryPiece& piece) const {
  const ContourUse& use = model_.use({piece.contour, piece.use});
  const Surface& surface = model_.surface(piece.patch);
  const Jet jet = surface.evaluate(use.curve->evaluate(0.5 * (piece.t0 + piece.t1)), Order::First);
  const Vec3 left = jet.du.cross(jet.dv).cross(piece.to - piece.from);
  const double norm = left.norm();
  if (!(norm > 0)) return false;
  piece.middle = jet.point;
  piece.inward = (use.is_forward ? 1 : -1) / norm * left;
  piece.sag = distance_from_chord(piece, piece.middle);
  for (const double share : {0.25, 0.75}) {
    const Uv uv = use.curve->evaluate((1 - share) * piece.t0 + share * piece.t1);
    const Vec3 p = surface.evaluate(uv, Order::Position).point;
    piece.sag = std::max(piece.sag, distance_from_chord(piece, p));
  }
  return true;
}

void BoundaryPieces::collect(int index, double tolerance) {
  for (const PatchLoop& loop : model_.patch(index).loops) {
    for (const LoopEntry& entry : loop) collect(index, entry, tolerance);
  }
}

void BoundaryPieces::collect(int index, const LoopEntry& entry, double tolerance) {
  const Contour& contour = model_.contour(entry);
  if (contour.is_smooth || contour.is_degenerate) return;
  const CurveOnSurface curve(model_.patch(index).surface, model_.use(entry).curve, contour.breaks);
  const auto points = curve_polyline(curve, tolerance);
  BoundaryPiece piece;
  piece.patch = index;
  piece.contour = entry.contour;
  piece.use = entry.use;
  piece.whole = length(points);
  double way = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    piece.t0 = points[i - 1].t;
    piece.t1 = points[i].t;
    piece.from = points[i - 1].point;
    piece.to = points[i].point;
    piece.way_length = piece.width();
    piece.way = way + 0.5 * piece.way_length;
    way += piece.way_length;
    if (complete(piece)) pieces_.push_back(piece);
  }
}

void BoundaryPieces::plant_tree() {
  std::vector<PieceVolume> volumes;
  for (const BoundaryPiece& piece : pieces_) {
    PieceVolume& volume = volumes.emplace_back();
    volume.chords.extend(piece.from).extend(piece.to);
    volume.inward.extend(piece.inward);
  }
  tree_ = PieceTree(volumes);
}

std::vector<BoundaryPiece> BoundaryPieces::halves(const BoundaryPiece& piece) const {
  BoundaryPiece first = piece, second = piece;
  first.t1 = second.t0 = 0.5 * (piece.t0 + piece.t1);
  first.to = second.from = piece.middle;
  const double widths = first.width() + second.width();
  if (!(widths > 0)) return {};
  first.way_length = first.width() / widths * piece.way_length;
  second.way_length = piece.way_length - first.way_length;
  first.way = piece.way - 0.5 * second.way_length;
  second.way = piece.way + 0.5 * first.way_length;
  std::vector<BoundaryPiece> result;
  for (BoundaryPiece* half : {&first, &second}) {
    if (complete(*half)) result.push_back(*half);
  }
  return result;
}

std::optional<BoundaryPoint> BoundaryPieces::nearest(const Vec3& p, const Facing& facing,
                                                     const Accepts& accepts) const {
  NearestPoint search{*this, p, facing, accepts, reach_};
  Eigen::BVMinimize(tree_, search);
  return search.found;
}

bool BoundaryPieces::are_joined(const BoundaryPiece& piece, const BoundaryPoint& point) const {
  const double same_point = kSamePoint * piece.whole;
  return point.distance <= same_point ||
         way_between(piece, point) <= kLeastWay * point.distance + same_point ||
         are_in_cusp(piece, point);
}

/// True if the contours of both leave a vertex that they have in common in the same direction.
///
/// Between them is room for flat elements only, whatever their size.
bool BoundaryPieces::are_in_cusp(const BoundaryPiece& piece, const BoundaryPoint& point) const {
  const BoundaryPiece& other = (*this)[point.piece];
  if (piece.contour == other.contour) return false;
  const Contour &a = model_.contour(piece.contour), &b = model_.contour(other.contour);
  const auto direction = [this](const BoundaryPiece& of, bool is_at_end) {
    const ContourUse& use = model_.use({of.contour, of.use});
    const Vec3 from = model_.point(use, is_at_end ? 1 : 0);
    return (model_.point(use, is_at_end ? 1 - kCornerShare : kCornerShare) - from).normalized();
  };
  for (const bool is_end_a : {false, true}) {
    for (const bool is_end_b : {false, true}) {
      if ((is_end_a ? a.end : a.start) != (is_end_b ? b.end : b.start)) continue;
      if (direction(piece, is_end_a).dot(direction(other, is_end_b)) > kCuspCosine) return true;
    }
  }
  return false;
}

/// Infinite if the contours have no vertex in common.
double BoundaryPieces::way_between(const BoundaryPiece& piece, const BoundaryPoint& point) const {
  const BoundaryPiece& other = (*this)[point.piece];
  const Contour& a = model_.contour(piece.contour);
  const Contour& b = model_.contour(other.contour);
  const double way = other.way + (point.share - 0.5) * other.way_length;
  if (piece.contour == other.contour) {
    const double between = std::abs(piece.way - way);
    return a.start == a.end ? std::min(between, piece.whole - between) : between;
  }
  double least = std::numeric_limits<double>::infinity();
  const auto join = [&](int vertex_a, double way_a, int vertex_b, double way_b) {
    if (vertex_a == vertex_b) least = std::min(least, way_a + way_b);
  };
  join(a.start, piece.way, b.start, way);
  join(a.start, piece.way, b.end, other.whole - way);
  join(a.end, piece.whole - piece.way, b.start, way);
  join(a.end, piece.whole - piece.way, b.end, other.whole - way);
  return least;
}

void BoundaryPieces::straighten() {
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<char> is_bent = find_bent();
    if (std::find(is_bent.begin(), is_bent.end(), 1) == is_bent.end()) return;
    std::vector<BoundaryPiece> pieces;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (is_bent[i]) {
        for (const BoundaryPiece& half : halves(pieces_[i])) pieces.push_back(half);
      } else {
        pieces.push_back(pieces_[i]);
      }
    }
    pieces_ = std::move(pieces);
    plant_tree();
  }
}

/// Pieces too far from their chords for what may be opposite to them, or to what they are opposite
/// of.
std::vector<char> BoundaryPieces::find_bent() const {
  std::vector<char> is_bent(pieces_.size(), 0);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const BoundaryPiece& piece = pieces_[i];
    const auto opposite = nearest(piece.middle, {piece.inward}, [&](const BoundaryPoint& point) {
      return piece.inward.dot((*this)[point.piece].inward) < 0 && !are_joined(piece, point);
    });
    if (!opposite) continue;
    for (const std::size_t k : {i, static_cast<std::size_t>(opposite->piece)}) {
      const double gap = std::max(opposite->distance, least_gap_);
      if (pieces_[k].sag > kSagShare * gap) is_bent[k] = 1;
    }
  }
  return is_bent;
}

}  // namespace surfmesh::detail
