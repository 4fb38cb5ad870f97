// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/near_misses.hh"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/geometry/segment_distance.hh"

namespace surfmesh {
namespace {

/// A stretch along another contour is at least this part of the samples: curves that touch or
/// leave a corner under a small angle are near for less.
constexpr std::size_t kLeastSamples = kLineSamples / 4;

/// A stretch is longer than this many gaps, or it is short rather than near.
constexpr double kMissLengthPerGap = 4;

/// A piece between ends of sides that are nearly one is at most this share of its sides.
constexpr double kShortShare = 0.01;

/// Smaller than the distance from p to the curve: a smooth curve is within a quarter of the
/// longest step of the line through its samples (a half circle over one step would be at half).
double least_distance(const Vec3& p, const SampledLine& curve) {
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    result = std::min(result, segment_distance(p, curve.points[i - 1], curve.points[i]));
  }
  return result - curve.max_step() / 4;
}

double distance_to_curve(const Vec3& p, const SampledLine& curve, double t_guess) {
  return (curve.line.at(curve.line.project(p, t_guess)) - p).norm();
}

/// Samples first to last - 1 of a curve.
struct NearStretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The longest run of numbers for which `is_near` holds.
template <class Predicate>
NearStretch longest_run(std::size_t count, const Predicate& is_near) {
  NearStretch best;
  NearStretch current;
  for (std::size_t i = 0; i < count; ++i) {
    current = is_near(i) ? NearStretch{current.first, i + 1} : NearStretch{i + 1, i + 1};
    if (current.last - current.first > best.last - best.first) best = current;
  }
  return best;
}

double length(const SampledLine& curve, const NearStretch& stretch) {
  double result = 0;
  for (std::size_t i = stretch.first + 1; i < stretch.last; ++i) {
    result += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return result;
}

/// The point of a line that is nearest to a point.
Uv foot(const SidePiece& piece, const Vec3& point) {
  const SampledLine line = sample(piece.line);
  const double guess = sample_parameters(kLineSamples)[line.nearest(point)];
  return piece.line.at_uv(piece.line.project(point, guess));
}

/// True if two curves that are a gap apart at a point have only a narrow piece of a patch between
/// them.
bool bound_a_strip(const MatchedSides& matched, const NearMiss& pair, const Vec3& point) {
  const auto pieces = [&](int curve) -> const std::vector<MatchedPiece>& {
    return matched.curves[static_cast<std::size_t>(curve)].pieces;
  };
  for (const MatchedPiece& of_a : pieces(pair.a)) {
    for (const MatchedPiece& of_b : pieces(pair.b)) {
      const SidePiece &p = matched.piece(of_a), &q = matched.piece(of_b);
      if (p.line.patch != q.line.patch) continue;
      const Uv middle = lerp(foot(p, point), foot(q, point), 0.5);
      const Vec3 between = p.line.surface->evaluate(middle, Order::Position).point;
      if ((between - point).norm() <= pair.gap) return true;
    }
  }
  return false;
}

/// How a curve runs along another one.
struct Along {
  double gap = 0;  ///< greatest distance
  Vec3 middle;     ///< of the stretch
  bool is_whole;   ///< all the way
};

/// How a stretch of `a` runs along `b`, or nothing.
std::optional<Along> along(const SampledLine& a, const SampledLine& b, const JoinLengths& lengths) {
  const std::size_t count = a.points.size();
  const NearStretch rough = longest_run(
      count, [&](std::size_t i) { return least_distance(a.points[i], b) <= lengths.near; });
  if (rough.last - rough.first <= kLeastSamples) return std::nullopt;
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  std::vector<double> distances;
  for (const Vec3& p : a.points) {
    distances.push_back(distance_to_curve(p, b, parameters[b.nearest(p)]));
  }
  const NearStretch run =
      longest_run(count, [&](std::size_t i) { return distances[i] <= lengths.near; });
  if (run.last - run.first <= kLeastSamples) return std::nullopt;
  const auto begin = distances.begin();
  const double result = *std::max_element(begin + static_cast<std::ptrdiff_t>(run.first),
                                          begin + static_cast<std::ptrdiff_t>(run.last));
  if (length(a, run) < kMissLengthPerGap * std::max(result, lengths.join)) return std::nullopt;
  return Along{result, a.points[(run.first + run.last) / 2], run.last - run.first == count};
}

using Pair = std::pair<std::size_t, std::size_t>;

/// Pairs whose boxes meet when one is larger by `margin`.
std::vector<Pair> meeting_pairs(const std::vector<Box3>& boxes, double margin) {
  const BoxTree tree(boxes);
  const Vec3 reach = Vec3::Constant(margin);
  std::vector<Pair> result;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const std::size_t j : tree.meeting({boxes[i].min() - reach, boxes[i].max() + reach})) {
      if (j > i) result.emplace_back(i, j);
    }
  }
  return result;
}

/// True if a curve is so short that the vertices at its ends are nearly one.
bool is_short(const MatchedSides& matched, const MatchedCurve& curve, double near) {
  const double length = curve.first.length();
  if (length > near || matched.is_degenerate(curve)) return false;
  return std::all_of(curve.pieces.begin(), curve.pieces.end(), [&](const MatchedPiece& piece) {
    return length <= kShortShare * matched.side_of(piece).curve.length();
  });
}

/// How curves run along each other, or nothing. Where both do all the way, the gap is the greatest
/// distance of either from the other.
std::optional<Along> along_each_other(const SampledLine& a, const SampledLine& b,
                                      const JoinLengths& lengths) {
  std::optional<Along> found = along(a, b, lengths);
  const std::optional<Along> other = along(b, a, lengths);
  if (!found || !other) return found ? found : other;
  if (found->is_whole && other->is_whole) found->gap = std::max(found->gap, other->gap);
  return found;
}

std::vector<NearMiss> near_pairs(const MatchedSides& matched, const JoinLengths& lengths) {
  std::vector<Box3> boxes;
  for (const MatchedCurve& curve : matched.curves) boxes.push_back(curve.first.box());
  std::vector<NearMiss> result;
  for (const auto& [i, j] : meeting_pairs(boxes, lengths.near)) {
    const MatchedCurve &a = matched.curves[i], &b = matched.curves[j];
    if (matched.is_degenerate(a) || matched.is_degenerate(b)) continue;
    if (a.pieces.size() > 1 && b.pieces.size() > 1) continue;
    if (is_short(matched, a, lengths.near) || is_short(matched, b, lengths.near)) continue;
    const auto found = along_each_other(a.first, b.first, lengths);
    if (!found) continue;
    const NearMiss pair{static_cast<int>(i), static_cast<int>(j), found->gap};
    if (!bound_a_strip(matched, pair, found->middle)) result.push_back(pair);
  }
  return result;
}

using VertexPair = std::pair<int, int>;  ///< the lower number first

VertexPair ends_of(const MatchedSides& matched, const MatchedCurve& curve) {
  const SidePiece& piece = matched.front_of(curve);
  return std::minmax(piece.start, piece.end);
}

/// Ends of curves that run along each other.
std::set<VertexPair> near_ends(const MatchedSides& matched, const std::vector<NearMiss>& pairs) {
  std::set<VertexPair> result;
  for (const NearMiss& pair : pairs) {
    const auto ends = [&](int curve) {
      return ends_of(matched, matched.curves[static_cast<std::size_t>(curve)]);
    };
    const VertexPair a = ends(pair.a), b = ends(pair.b);
    for (const int i : {a.first, a.second}) {
      for (const int j : {b.first, b.second}) result.insert(std::minmax(i, j));
    }
  }
  return result;
}

}  // namespace

std::vector<NearMiss> find_near_misses(const MatchedSides& matched, const JoinLengths& lengths) {
  std::vector<NearMiss> result = near_pairs(matched, lengths);
  const std::set<VertexPair> known = near_ends(matched, result);
  for (std::size_t c = 0; c < matched.curves.size(); ++c) {
    const MatchedCurve& curve = matched.curves[c];
    if (!is_short(matched, curve, lengths.near) || known.contains(ends_of(matched, curve))) {
      continue;
    }
    result.push_back({static_cast<int>(c), -1, curve.first.length()});
  }
  return result;
}

}  // namespace surfmesh
