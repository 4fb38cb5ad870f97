// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/proximity.hh"

#include <Eigen/Core>
#include <unsupported/Eigen/BVH>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "surfmesh/control/curve_polyline.hh"

namespace surfmesh {
namespace {

/// Cosine of the greatest angle between the way across and an inward direction, and of the least
/// angle, negated, between two inward directions that face each other.
constexpr double kFacing = 0.5;

/// A way along the boundary that is no more than so many gaps is a corner or a bend, not a gap.
constexpr double kLeastWay = 6;

/// Longest piece in gaps.
constexpr double kLongestPiece = 2;

/// Halvings of one chord.
constexpr int kMaxHalvings = 7;

/// Distance of chords from contours as a share of hmax; gaps below it are seen with finer pieces,
/// as these are halved on the contour itself.
constexpr double kChordShare = 0.02;

/// Ratio of the size along the boundary to that across the gap.
constexpr double kAlong = 2;

/// A piece of a contour use: a chord with what belongs to its middle.
struct Piece {
  int contour = -1;
  int use = -1;
  double t0 = 0, t1 = 0;
  Vec3 from, to;
  Vec3 inward;        ///< unit vector at the middle, in the tangent plane
  double way = 0;     ///< along the contour from its start to the middle
  double length = 0;  ///< of the whole contour
};

Vec3 nearest_point(const Piece& piece, const Vec3& p) {
  return piece.from + nearest_share(piece.from, piece.to, p) * (piece.to - piece.from);
}

using Box = Eigen::AlignedBox3d;
using PieceTree = Eigen::KdBVH<double, 3, int>;

/// Finds the least gap from a point among the pieces in a tree: `gap_to` gives the other end of the
/// gap on a piece, or none if it is not below the least so far.
template <class GapTo>
struct LeastGap {
  using Scalar = double;  // which Eigen asks for

  const Vec3& point;
  double least;  ///< at first the reach
  GapTo gap_to;
  std::optional<Vec3> found = {};

  double minimumOnVolume(const Box& box) const {
    const double distance = std::sqrt(box.squaredExteriorDistance(point));
    return distance < least ? distance : std::numeric_limits<double>::infinity();
  }

  double minimumOnObject(int piece) {
    const std::optional<Vec3> end = gap_to(piece, least);
    if (!end) return std::numeric_limits<double>::infinity();
    least = (*end - point).norm();
    found = end;
    return least;
  }
};

class GapSearch {
 public:
  GapSearch(const Model& model, int patch, const Sizing& sizing, const SizeBounds& bounds)
      : model_(model),
        patch_(patch),
        surface_(*model.patches[static_cast<std::size_t>(patch)].surface),
        sizing_(sizing),
        bounds_(bounds),
        reach_(sizing.proximity * bounds.hmax) {}

  std::vector<PlacedSize> run() {
    for (const PatchLoop& loop : model_.patches[static_cast<std::size_t>(patch_)].loops) {
      for (const LoopEntry& entry : loop) collect(entry);
    }
    plant_tree();
    for (const Piece& piece : pieces_) cross(piece, 0);
    return std::move(sizes_);
  }

 private:
  const Contour& contour(int index) const {
    return model_.contours[static_cast<std::size_t>(index)];
  }

  const ContourUse& use(const Piece& piece) const {
    return contour(piece.contour).uses[static_cast<std::size_t>(piece.use)];
  }

  Vec3 point(const Piece& piece, double t) const {
    return surface_.evaluate(use(piece).curve->evaluate(t), Order::Position).point;
  }

  void collect(const LoopEntry& entry) {
    const Contour& c = contour(entry.contour);
    if (c.is_smooth || c.is_degenerate) return;
    const auto& curve = c.uses[static_cast<std::size_t>(entry.use)].curve;
    const auto surface = model_.patches[static_cast<std::size_t>(patch_)].surface;
    const auto points =
        curve_polyline(CurveOnSurface(surface, curve, c.part_count), kChordShare * bounds_.hmax);
    const double whole = length(points);
    double way = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      Piece piece{entry.contour,
                  entry.use,
                  points[i - 1].t,
                  points[i].t,
                  points[i - 1].point,
                  points[i].point,
                  Vec3::Zero(),
                  0,
                  whole};
      const double step = (piece.to - piece.from).norm();
      piece.way = way + 0.5 * step;
      way += step;
      if (step > 0 && set_inward(piece)) pieces_.push_back(piece);
    }
  }

  /// False where there is no tangent plane.
  bool set_inward(Piece& piece) const {
    const Uv uv = use(piece).curve->evaluate(0.5 * (piece.t0 + piece.t1));
    const Jet jet = surface_.evaluate(uv, Order::First);
    const Vec3 left = jet.du.cross(jet.dv).cross(piece.to - piece.from);
    const double norm = left.norm();
    if (!(norm > 0)) return false;
    piece.inward = (use(piece).is_forward ? 1 : -1) / norm * left;
    return true;
  }

  void plant_tree() {
    std::vector<int> indices;
    std::vector<Box> boxes;
    for (const Piece& piece : pieces_) {
      indices.push_back(static_cast<int>(indices.size()));
      boxes.push_back(Box(piece.from).extend(piece.to));
    }
    tree_.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  }

  /// The way along the boundary from one piece to the other, infinite if they are not neighbours.
  double way_between(const Piece& a, const Piece& b) const {
    const Contour& ca = contour(a.contour);
    const Contour& cb = contour(b.contour);
    if (a.contour == b.contour) {
      const double way = std::abs(a.way - b.way);
      return ca.start == ca.end ? std::min(way, a.length - way) : way;
    }
    double least = std::numeric_limits<double>::infinity();
    const auto join = [&](int vertex_a, double way_a, int vertex_b, double way_b) {
      if (vertex_a == vertex_b) least = std::min(least, way_a + way_b);
    };
    join(ca.start, a.way, cb.start, b.way);
    join(ca.start, a.way, cb.end, b.length - b.way);
    join(ca.end, a.length - a.way, cb.start, b.way);
    join(ca.end, a.length - a.way, cb.end, b.length - b.way);
    return least;
  }

  /// The point of another piece nearest to p, if its gap is below `least` and the two face each
  /// other.
  std::optional<Vec3> facing_point(const Piece& piece, const Vec3& p, const Piece& other,
                                   double least) const {
    if (piece.inward.dot(other.inward) > -kFacing) return std::nullopt;
    const Vec3 q = nearest_point(other, p);
    const double gap = (q - p).norm();
    if (!(gap > 0 && gap < least)) return std::nullopt;
    const bool is_facing =
        (q - p).dot(piece.inward) >= kFacing * gap && (p - q).dot(other.inward) >= kFacing * gap;
    if (!is_facing || way_between(piece, other) <= kLeastWay * gap) return std::nullopt;
    return q;
  }

  /// The point nearest to p across the patch within reach.
  std::optional<Vec3> find_opposite(const Piece& piece, const Vec3& p) const {
    const auto gap_to = [&](int other, double least) {
      return facing_point(piece, p, pieces_[static_cast<std::size_t>(other)], least);
    };
    LeastGap<decltype(gap_to)> gap{p, reach_, gap_to};
    Eigen::BVMinimize(tree_, gap);
    return gap.found;
  }

  /// Add the size across from the middle of a piece, or from finer pieces.
  void cross(const Piece& piece, int depth) {
    const double t = 0.5 * (piece.t0 + piece.t1);
    const Vec3 p = point(piece, t);
    const auto opposite = find_opposite(piece, p);
    if (!opposite) return;
    const double width = (piece.to - piece.from).norm();
    const double gap = (*opposite - p).norm();
    if (width <= kLongestPiece * gap || depth == kMaxHalvings) {
      add(p, *opposite, 0.5 * width);
      return;
    }
    Piece first = piece, second = piece;
    first.t1 = second.t0 = t;
    first.to = second.from = p;
    first.way -= 0.25 * width;
    second.way += 0.25 * width;
    for (Piece* half : {&first, &second}) {
      if (set_inward(*half)) cross(*half, depth + 1);
    }
  }

  void add(const Vec3& p, const Vec3& q, double radius) {
    const double size = bounds_.clamp((q - p).norm() / sizing_.proximity);
    PlacedSize placed;
    placed.from = p;
    placed.to = q;
    placed.at_from = placed.at_to = {size, bounds_.clamp(kAlong * size)};
    placed.follows_segment = true;
    placed.radius = radius;
    sizes_.push_back(placed);
  }

  const Model& model_;
  int patch_;
  const Surface& surface_;
  const Sizing& sizing_;
  const SizeBounds& bounds_;
  double reach_;
  std::vector<Piece> pieces_;
  PieceTree tree_;  ///< of the indices of pieces_
  std::vector<PlacedSize> sizes_;
};

}  // namespace

std::vector<PlacedSize> proximity_sizes(const Model& model, int patch, const Sizing& sizing,
                                        const SizeBounds& bounds) {
  if (sizing.proximity == 0) return {};
  return GapSearch(model, patch, sizing, bounds).run();
}

}  // namespace surfmesh
