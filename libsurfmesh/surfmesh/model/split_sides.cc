// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/split_sides.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "surfmesh/core/disjoint_sets.hh"

namespace surfmesh {
namespace {

/// A vertex on a side is looked for around a sample at most this many steps between samples away:
/// in the middle of a step it is half a step from the nearest sample, more where the speed varies.
constexpr double kReachSteps = 2;

/// A stretch of a side that starts and ends at a vertex is that vertex if it stays this near, in
/// units of the tolerance: both ends may be off by one.
constexpr double kCollapsed = 4;

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& point, double width) {
  const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / width)); };
  return {index(point.x()), index(point.y()), index(point.z())};
}

/// Unite points of neighbouring cells that are within the distance.
void unite_near(const std::vector<Vec3>& points, double distance, DisjointSets& sets) {
  std::map<Cell, std::vector<std::size_t>> cells;
  const double width = 2 * distance;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell home = cell_of(points[i], width);
    for (int k = 0; k < 27; ++k) {
      const auto found =
          cells.find({home[0] + k % 3 - 1, home[1] + k / 3 % 3 - 1, home[2] + k / 9 - 1});
      if (found == cells.end()) continue;
      for (const std::size_t j : found->second) {
        if ((points[i] - points[j]).norm() <= distance) sets.unite(i, j);
      }
    }
    cells[home].push_back(i);
  }
}

/// The sets, numbered as they first appear.
std::vector<int> number_sets(std::size_t count, DisjointSets& sets) {
  std::vector<int> result(count, -1);
  int next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = sets.find(i);
    result[i] = first == i ? next++ : result[first];
  }
  return result;
}

bool is_one_point(const std::vector<Vec3>& points, double tolerance) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return (p - points.front()).norm() <= tolerance; });
}

/// Vertices sorted along the axis on which they spread most.
class SortedVertices {
 public:
  explicit SortedVertices(const std::vector<Vec3>& vertices) : vertices_(&vertices) {
    Box3 box;
    for (const Vec3& vertex : vertices) box.extend(vertex);
    box.sizes().maxCoeff(&axis_);
    order_.resize(vertices.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int i, int j) { return coordinate(i) < coordinate(j); });
  }

  std::vector<int> inside(const Box3& box) const {
    const auto first = std::lower_bound(order_.begin(), order_.end(), box.min()[axis_],
                                        [&](int i, double x) { return coordinate(i) < x; });
    std::vector<int> result;
    for (auto i = first; i != order_.end() && coordinate(*i) <= box.max()[axis_]; ++i) {
      if (box.contains((*vertices_)[static_cast<std::size_t>(*i)])) result.push_back(*i);
    }
    return result;
  }

 private:
  double coordinate(int i) const { return (*vertices_)[static_cast<std::size_t>(i)][axis_]; }

  const std::vector<Vec3>* vertices_;
  Eigen::Index axis_ = 0;
  std::vector<int> order_;
};

/// A place of a side where a vertex lies.
struct Cut {
  double t = 0;
  int vertex = -1;
};

class Splitter {
 public:
  Splitter(const SplitSides& split, double tolerance)
      : vertices_(&split.vertices), sorted_(split.vertices), tolerance_(tolerance) {}

  /// All cuts of a side, its ends included.
  std::vector<Cut> cuts(const PatchSide& side, int start, int end) const;

 private:
  const Vec3& position(int vertex) const { return (*vertices_)[static_cast<std::size_t>(vertex)]; }
  std::vector<double> passes(const PatchSide& side, const Vec3& x) const;
  bool is_collapsed(const PatchSide& side, const Cut& from, const Cut& to) const;
  std::vector<Cut> without_repeats(const PatchSide& side, const std::vector<Cut>& cuts) const;

  const std::vector<Vec3>* vertices_;
  SortedVertices sorted_;
  double tolerance_;
};

/// Places where the side passes through x: from every sample nearer to x than its neighbours, so
/// that a side may pass several times. Its own ends are not looked at.
std::vector<double> Splitter::passes(const PatchSide& side, const Vec3& x) const {
  const std::vector<Vec3>& points = side.curve.points;
  const std::vector<double> parameters = sample_parameters(static_cast<int>(points.size()) - 1);
  const double reach = kReachSteps * side.curve.max_step();
  const auto distance = [&](std::size_t i) { return (points[i] - x).norm(); };
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double here = distance(i);
    const bool is_end = i == 0 || i + 1 == points.size();
    if (here > reach || (is_end && here <= tolerance_)) continue;
    if (i > 0 && distance(i - 1) < here) continue;
    if (i + 1 < points.size() && distance(i + 1) <= here) continue;
    const double t = side.curve.line.project(x, parameters[i]);
    if ((side.curve.line.at(t) - x).norm() <= tolerance_) result.push_back(t);
  }
  return result;
}

/// True if the side does not leave the vertex between two cuts.
bool Splitter::is_collapsed(const PatchSide& side, const Cut& from, const Cut& to) const {
  if (from.vertex != to.vertex) return false;
  const SampledLine stretch = sample(side.curve.line.part(from.t, to.t), kLineSamples / 4);
  return std::all_of(stretch.points.begin(), stretch.points.end(), [&](const Vec3& p) {
    return (p - position(from.vertex)).norm() <= kCollapsed * tolerance_;
  });
}

/// Cuts that are the same place as the one before are left out, but the ends of the side stay.
std::vector<Cut> Splitter::without_repeats(const PatchSide& side,
                                           const std::vector<Cut>& cuts) const {
  std::vector<Cut> result{cuts.front()};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (is_collapsed(side, result.back(), cuts[i])) {
      const bool is_last = i + 1 == cuts.size();
      if (!is_last) continue;
      if (result.size() > 1) result.pop_back();
    }
    result.push_back(cuts[i]);
  }
  return result;
}

std::vector<Cut> Splitter::cuts(const PatchSide& side, int start, int end) const {
  std::vector<Cut> inner;
  for (const int vertex : sorted_.inside(side.curve.box())) {
    for (const double t : passes(side, position(vertex))) inner.push_back({t, vertex});
  }
  std::stable_sort(inner.begin(), inner.end(),
                   [](const Cut& a, const Cut& b) { return a.t < b.t; });
  std::vector<Cut> all{{0, start}};
  all.insert(all.end(), inner.begin(), inner.end());
  all.push_back({1, end});
  return without_repeats(side, all);
}

void append_pieces(const PatchSide& side, int side_index, const std::vector<Cut>& cuts,
                   std::vector<SidePiece>& pieces) {
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    pieces.push_back({side_index, static_cast<int>(i), cuts.size() == 2, cuts[i].vertex,
                      cuts[i + 1].vertex, side.curve.line.part(cuts[i].t, cuts[i + 1].t)});
  }
}

/// The vertex of each side's start and end, one after the other.
std::vector<int> number_ends(const std::vector<PatchSide>& sides, double tolerance) {
  std::vector<Vec3> ends;
  for (const PatchSide& side : sides) {
    ends.push_back(side.curve.points.front());
    ends.push_back(side.curve.points.back());
  }
  DisjointSets sets(ends.size());
  unite_near(ends, tolerance, sets);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i].is_degenerate) sets.unite(2 * i, 2 * i + 1);
  }
  return number_sets(ends.size(), sets);
}

}  // namespace

SplitSides split_sides(std::vector<PatchSide>& sides, double tolerance) {
  for (PatchSide& side : sides) side.is_degenerate = is_one_point(side.curve.points, tolerance);
  const std::vector<int> ends = number_ends(sides, tolerance);
  SplitSides result;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (static_cast<std::size_t>(ends[i]) < result.vertices.size()) continue;
    const std::vector<Vec3>& points = sides[i / 2].curve.points;
    result.vertices.push_back(i % 2 == 0 ? points.front() : points.back());
  }
  const Splitter splitter(result, tolerance);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const int start = ends[2 * i];
    const int end = ends[2 * i + 1];
    const std::vector<Cut> cuts = sides[i].is_degenerate ? std::vector<Cut>{{0, start}, {1, end}}
                                                         : splitter.cuts(sides[i], start, end);
    append_pieces(sides[i], static_cast<int>(i), cuts, result.pieces);
  }
  return result;
}

}  // namespace surfmesh
