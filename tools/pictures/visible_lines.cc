// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/visible_lines.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pictures/long_lines.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// Edges take at most this share of a triangle, and fade altogether where it is lower than so many
/// pixels.
constexpr double kInkShare = 0.42;
constexpr double kLeastRoom = 0.9;

/// Steps of opacity.
constexpr int kLevels = 16;

/// Pixels between the places at which an edge is looked at.
constexpr double kStep = 0.5;

/// A level of opacity; 0 is not drawn, above kLevels a contour.
int level_of(const SceneEdge& edge, const LineOptions& options) {
  if (edge.is_contour && options.contours) return kLevels + 1;
  if (!options.edges) return 0;
  // Three sides, each shared with another face, take 3 width / room of a triangle.
  const double share = kInkShare * (edge.room - kLeastRoom) / (3 * options.edge_width);
  return static_cast<int>(std::lround(kLevels * std::clamp(share, 0.0, 1.0)));
}

ScenePoint between(const ScenePoint& a, const ScenePoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
}

/// A part of an edge that is seen, from 0 to 1.
struct Run {
  std::size_t edge = 0;
  double from = 0;
  double to = 1;

  bool is_whole() const { return from <= 0 && to >= 1; }
};

void find_runs(const Scene& scene, const DepthBuffer& buffer, std::size_t e,
               std::vector<Run>& runs) {
  const SceneEdge& edge = scene.edges[e];
  const ScenePoint &a = scene.points[static_cast<std::size_t>(edge.from)],
                   &b = scene.points[static_cast<std::size_t>(edge.to)];
  // Only the part in the picture is walked, however far the others are away.
  const double width = double(buffer.columns()) / buffer.samples(),
               height = double(buffer.rows()) / buffer.samples();
  double low = 0, high = 1;
  const auto cut = [&](double from, double to, double end) {
    const double step = to - from;
    if (!(std::abs(step) > 0)) {
      if (from < 0 || from > end) high = -1;
      return;
    }
    const auto [first, last] = std::minmax({(0 - from) / step, (end - from) / step});
    low = std::max(low, first);
    high = std::min(high, last);
  };
  cut(a.x, b.x, width);
  cut(a.y, b.y, height);
  const double length = std::hypot(b.x - a.x, b.y - a.y) * (high - low);
  if (!(high > low) || !std::isfinite(length)) return;
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length / kStep)));
  const double step = (high - low) / static_cast<double>(count);
  bool is_open = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double middle = low + (static_cast<double>(i) + 0.5) * step;
    if (!buffer.is_visible(between(a, b, middle))) {
      is_open = false;
      continue;
    }
    if (!is_open) runs.push_back({e, low + static_cast<double>(i) * step, 0});
    is_open = true;
    runs.back().to = i + 1 == count ? high : low + static_cast<double>(i + 1) * step;
  }
}

/// All runs, in the order of their edges.
std::vector<Run> all_runs(const Scene& scene, const DepthBuffer& buffer,
                          const std::vector<int>& levels) {
  constexpr std::size_t kAtOnce = 4096;
  std::vector<std::vector<Run>> parts((scene.edges.size() + kAtOnce - 1) / kAtOnce);
  share_indices(parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min(scene.edges.size(), (part + 1) * kAtOnce);
    for (std::size_t e = part * kAtOnce; e < end; ++e) {
      if (levels[e] > 0) find_runs(scene, buffer, e, parts[part]);
    }
  });
  std::vector<Run> runs;
  for (const std::vector<Run>& part : parts) runs.insert(runs.end(), part.begin(), part.end());
  return runs;
}

/// Collects runs of a style: whole edges as pairs of points, to be joined.
struct Level {
  std::vector<std::array<int, 2>> whole;
  std::vector<PicturePoints> parts;
};

std::vector<Level> by_level(const Scene& scene, const std::vector<Run>& runs,
                            const std::vector<int>& levels) {
  std::vector<Level> result(kLevels + 2);
  for (const Run& run : runs) {
    const SceneEdge& edge = scene.edges[run.edge];
    Level& level = result[static_cast<std::size_t>(levels[run.edge])];
    if (run.is_whole()) {
      level.whole.push_back({edge.from, edge.to});
      continue;
    }
    const ScenePoint &a = scene.points[static_cast<std::size_t>(edge.from)],
                     &b = scene.points[static_cast<std::size_t>(edge.to)];
    const ScenePoint from = between(a, b, run.from), to = between(a, b, run.to);
    level.parts.push_back({{from.x, from.y}, {to.x, to.y}});
  }
  return result;
}

}  // namespace

std::vector<StyledLines> visible_lines(const Scene& scene, const DepthBuffer& buffer,
                                       const LineOptions& options) {
  std::vector<int> levels;
  levels.reserve(scene.edges.size());
  for (const SceneEdge& edge : scene.edges) levels.push_back(level_of(edge, options));
  const std::vector<Level> collected = by_level(scene, all_runs(scene, buffer, levels), levels);
  std::vector<PicturePoint> points;
  points.reserve(scene.points.size());
  for (const ScenePoint& point : scene.points) points.push_back({point.x, point.y});
  std::vector<StyledLines> result;
  for (int i = 1; i <= kLevels + 1; ++i) {
    const auto& [whole, parts] = collected[static_cast<std::size_t>(i)];
    if (whole.empty() && parts.empty()) continue;
    StyledLines& lines = result.emplace_back();
    lines.style = i > kLevels ? PictureStyle{"none", "#1c2430", options.contour_width}
                              : PictureStyle{"none", "#243040", options.edge_width,
                                             static_cast<double>(i) / kLevels};
    lines.lines = long_lines(points, whole);
    lines.lines.insert(lines.lines.end(), parts.begin(), parts.end());
  }
  return result;
}

}  // namespace surfmesh
