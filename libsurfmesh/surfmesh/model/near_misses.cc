// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/near_misses.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/geometry/segment_distance.hh"

namespace surfmesh {
namespace {

/// More of them are only counted.
constexpr std::size_t kMostNotices = 20;

/// A stretch along another contour is at least this part of the samples: curves that touch or
/// leave a corner under a small angle are near for less.
constexpr std::size_t kLeastSamples = kLineSamples / 4;

/// A stretch is longer than this many gaps, or it is short rather than near.
constexpr double kLengthPerGap = 4;

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
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The longest run of numbers for which `is_near` holds.
template <class Predicate>
Stretch longest_run(std::size_t count, const Predicate& is_near) {
  Stretch best;
  Stretch current;
  for (std::size_t i = 0; i < count; ++i) {
    current = is_near(i) ? Stretch{current.first, i + 1} : Stretch{i + 1, i + 1};
    if (current.last - current.first > best.last - best.first) best = current;
  }
  return best;
}

double length(const SampledLine& curve, const Stretch& stretch) {
  double result = 0;
  for (std::size_t i = stretch.first + 1; i < stretch.last; ++i) {
    result += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return result;
}

/// How a curve runs along another one.
struct Gap {
  double greatest = 0;    ///< distance
  bool is_whole = false;  ///< all the way
};

/// True if two curves of one patch have only a narrow piece of it between them.
bool bound_a_strip(const SampledLine& a, const SampledLine& b, std::size_t sample, double gap) {
  if (a.line.patch != b.line.patch) return false;
  const double t = sample_parameters(kLineSamples)[sample];
  const Vec3& point = a.points[sample];
  const double foot = b.line.project(point, sample_parameters(kLineSamples)[b.nearest(point)]);
  const Uv middle = lerp(a.line.at_uv(t), b.line.at_uv(foot), 0.5);
  return (a.line.surface->evaluate(middle, Order::Position).point - point).norm() <= gap;
}

/// How a stretch of `a` runs along `b`, or nothing.
std::optional<Gap> gap(const SampledLine& a, const SampledLine& b, const JoinLengths& lengths) {
  const std::size_t count = a.points.size();
  const Stretch rough = longest_run(
      count, [&](std::size_t i) { return least_distance(a.points[i], b) <= lengths.near; });
  if (rough.last - rough.first <= kLeastSamples) return std::nullopt;
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  std::vector<double> distances;
  for (const Vec3& p : a.points) {
    distances.push_back(distance_to_curve(p, b, parameters[b.nearest(p)]));
  }
  const Stretch run =
      longest_run(count, [&](std::size_t i) { return distances[i] <= lengths.near; });
  if (run.last - run.first <= kLeastSamples) return std::nullopt;
  const auto begin = distances.begin();
  const double result = *std::max_element(begin + static_cast<std::ptrdiff_t>(run.first),
                                          begin + static_cast<std::ptrdiff_t>(run.last));
  if (result <= lengths.join || length(a, run) < kLengthPerGap * result) return std::nullopt;
  if (bound_a_strip(a, b, (run.first + run.last) / 2, result)) return std::nullopt;
  return Gap{result, run.last - run.first == count};
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

/// The least length of one digit that is some tenths greater than a gap.
double joining_for(double gap) {
  const double wanted = 1.3 * gap;
  const double digit = std::pow(10, std::floor(std::log10(wanted)));
  return std::ceil(wanted / digit) * digit;
}

std::string text_of(const ContourShape& a, const ContourShape& b, const Gap& gap, double join) {
  const std::string advice =
      gap.is_whole ? fmt::format("; joining = {:.1g} joins them", joining_for(gap.greatest)) : "";
  return fmt::format(
      "contours {} and {} are not joined: the gap between them is {:.3g}, more than {:.3g}{}",
      a.name, b.name, gap.greatest, join, advice);
}

}  // namespace

Notices near_miss_notices(const std::vector<ContourShape>& contours, const JoinLengths& lengths) {
  std::vector<Box3> boxes;
  boxes.reserve(contours.size());
  for (const ContourShape& contour : contours) boxes.push_back(contour.curve.box());
  Notices result;
  for (const auto& [i, j] : meeting_pairs(boxes, lengths.near)) {
    const ContourShape& a = contours[i];
    const ContourShape& b = contours[j];
    if (a.is_shared && b.is_shared) continue;
    std::optional<Gap> found = gap(a.curve, b.curve, lengths);
    if (!found) found = gap(b.curve, a.curve, lengths);
    if (!found) continue;
    if (result.size() == kMostNotices) {
      ++result.back().count;
      continue;
    }
    result.push_back(shortfall(NoticeKind::UnjoinedSides, text_of(a, b, *found, lengths.join)));
    result.back().contour = a.contour;
  }
  return result;
}

}  // namespace surfmesh
