// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/split_sides.hh"

#include <algorithm>

#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/model/point_cells.hh"

namespace surfmesh {
namespace {

/// A vertex on a side is looked for around a sample at most this many steps between samples away:
/// in the middle of a step it is half a step from the nearest sample, more where the speed varies.
constexpr double kReachSteps = 2;

/// A stretch between two cuts that stays this near to the vertex of the first, in units of the
/// tolerance, is no piece. Between cuts of one vertex it is that vertex: both ends may be off by
/// one. Between two vertices it would coincide with whatever else passes there, another side of its
/// own patch included, as no sample of it is farther away than a few tolerances.
constexpr double kLeastPiece = 4;

/// Unite points within the distance of each other.
void unite_near(const std::vector<Vec3>& points, double distance, DisjointSets& sets) {
  PointCells cells(distance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const std::size_t j : cells.near(points[i])) sets.unite(i, j);
    cells.add(points[i]);
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

/// Vertices that are looked for in boxes.
class VertexTree {
 public:
  explicit VertexTree(const std::vector<Vec3>& vertices)
      : vertices_(&vertices), tree_(boxes_of(vertices)) {
    Box3 box;
    for (const Vec3& vertex : vertices) box.extend(vertex);
    box.sizes().maxCoeff(&axis_);
  }

  /// In their order along the axis on which all spread most.
  std::vector<std::size_t> inside(const Box3& box) const {
    std::vector<std::size_t> result = tree_.meeting(box);
    std::stable_sort(result.begin(), result.end(), [this](std::size_t i, std::size_t j) {
      return (*vertices_)[i][axis_] < (*vertices_)[j][axis_];
    });
    return result;
  }

 private:
  static std::vector<Box3> boxes_of(const std::vector<Vec3>& vertices) {
    std::vector<Box3> boxes;
    for (const Vec3& vertex : vertices) boxes.emplace_back(vertex);
    return boxes;
  }

  const std::vector<Vec3>* vertices_;
  BoxTree tree_;
  Eigen::Index axis_ = 0;
};

/// A place of a side where a vertex lies.
struct Cut {
  double t = 0;
  int vertex = -1;
};

class Splitter {
 public:
  Splitter(const SplitSides& split, double tolerance)
      : vertices_(&split.vertices), tree_(split.vertices), tolerance_(tolerance) {}

  /// All cuts of a side, its ends included.
  std::vector<Cut> cuts(const PatchSide& side, int start, int end) const;

 private:
  const Vec3& position(int vertex) const { return (*vertices_)[static_cast<std::size_t>(vertex)]; }
  std::vector<double> passes(const PatchSide& side, const Vec3& x) const;
  bool is_too_short(const PatchSide& side, const Cut& from, const Cut& to) const;
  std::vector<Cut> far_enough(const PatchSide& side, const std::vector<Cut>& cuts) const;

  const std::vector<Vec3>* vertices_;
  VertexTree tree_;
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

/// True if the side does not leave the vertex of the first of two cuts between them.
bool Splitter::is_too_short(const PatchSide& side, const Cut& from, const Cut& to) const {
  const SampledLine stretch = sample(side.curve.line.part(from.t, to.t), kLineSamples / 4);
  return std::all_of(stretch.points.begin(), stretch.points.end(), [&](const Vec3& p) {
    return (p - position(from.vertex)).norm() <= kLeastPiece * tolerance_;
  });
}

/// Cuts too near to the one before are left out, but the ends of the side stay.
std::vector<Cut> Splitter::far_enough(const PatchSide& side, const std::vector<Cut>& cuts) const {
  std::vector<Cut> result{cuts.front()};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (is_too_short(side, result.back(), cuts[i])) {
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
  for (const std::size_t i : tree_.inside(side.curve.box())) {
    const int vertex = static_cast<int>(i);
    for (const double t : passes(side, position(vertex))) inner.push_back({t, vertex});
  }
  std::stable_sort(inner.begin(), inner.end(),
                   [](const Cut& a, const Cut& b) { return a.t < b.t; });
  std::vector<Cut> all{{0, start}};
  all.insert(all.end(), inner.begin(), inner.end());
  all.push_back({1, end});
  return far_enough(side, all);
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
