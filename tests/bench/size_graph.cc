// SPDX-License-Identifier: BSD-3-Clause
#include "bench/size_graph.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::judge {
namespace {

/// Columns and rows that a link of a grid reaches at most.
constexpr int kReach = 3;

/// A size whose trace falls by a smaller share is left, so that gradation ends. With 1e-6, the
/// counts of the models wave and knob differ by 0.01 %.
constexpr double kLeastFall = 1e-4;

/// The same across contours, whose directions are found by differences.
constexpr double kLeastFallAcross = 2e-3;

struct Range {
  double least;
  double greatest;
};

Range range_of(const SizeTensor& h) {
  const double mean = 0.5 * (h.h11 + h.h22);
  const double radius = eigenvalue_radius(0.5 * (h.h11 - h.h22), h.h12);
  return {mean - radius, mean + radius};
}

/// The minimum of two sizes, no shorter in any direction than the least length of both.
///
/// The minimum of two stretched sizes that are turned against each other is shorter than both. Each
/// link from point to point would shorten it further where the directions change, the more links
/// there are, and links around the tip of a cone without end: counts would never settle.
SizeTensor bounded_minimum(const SizeTensor& a, const SizeTensor& b) {
  const SizeTensor both = minimum(a, b);
  const double least = std::min(range_of(a).least, range_of(b).least);
  return clamp_sizes(both, least, std::max(least, range_of(both).greatest));
}

Turn product(const Turn& a, const Turn& b) {
  return {a.q11 * b.q11 + a.q12 * b.q21, a.q11 * b.q12 + a.q12 * b.q22,
          a.q21 * b.q11 + a.q22 * b.q21, a.q21 * b.q12 + a.q22 * b.q22};
}

/// To the frame of the contour, mirrored there if both patches lie on the same side of it, and on
/// to the other patch.
Turn unfolding(const ContourSide& from, const ContourSide& to) {
  const double sign = from.is_forward == to.is_forward ? -1 : 1;
  const Turn to_contour{from.cos, from.sin, -sign * from.sin, sign * from.cos};
  return product({to.cos, -to.sin, to.sin, to.cos}, to_contour);
}

}  // namespace

SizeTensor Turn::operator()(const SizeTensor& h) const {
  const double a11 = q11 * h.h11 + q12 * h.h12, a12 = q11 * h.h12 + q12 * h.h22;
  const double a21 = q21 * h.h11 + q22 * h.h12, a22 = q21 * h.h12 + q22 * h.h22;
  return {a11 * q11 + a12 * q12, a11 * q21 + a12 * q22, a21 * q21 + a22 * q22};
}

std::size_t SizeGraph::add_grid(int columns, int rows, const std::vector<SizedPoint>& points) {
  grids_.push_back({points_.size(), columns, rows});
  points_.insert(points_.end(), points.begin(), points.end());
  return grids_.back().first;
}

std::size_t SizeGraph::add_point(const SizedPoint& point) {
  points_.push_back(point);
  return points_.size() - 1;
}

void SizeGraph::link(std::size_t a, std::size_t b) {
  links_.emplace_back(static_cast<Index>(a), static_cast<Index>(b));
  links_.emplace_back(static_cast<Index>(b), static_cast<Index>(a));
}

void SizeGraph::link_across(const ContourSide& a, const ContourSide& b) {
  across_.push_back({static_cast<Index>(a.point), {static_cast<Index>(b.point), unfolding(a, b)}});
  across_.push_back({static_cast<Index>(b.point), {static_cast<Index>(a.point), unfolding(b, a)}});
}

void SizeGraph::grade(double grade) {
  if (grade == 0) return;
  growth_ = std::log(grade);
  sort_links();
  is_queued_.assign(points_.size(), 0);
  for (std::size_t i = 0; i < points_.size(); ++i) push(i);
  while (!queue_.empty()) {
    const std::size_t i = queue_.top().second;
    queue_.pop();
    if (!is_queued_[i]) continue;  // done since, with a lesser size
    is_queued_[i] = 0;
    spread(i);
  }
}

void SizeGraph::sort_links() {
  std::sort(links_.begin(), links_.end());
  std::stable_sort(across_.begin(), across_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
}

void SizeGraph::push(std::size_t point) {
  queue_.emplace(range_of(points_[point].size).least, static_cast<Index>(point));
  is_queued_[point] = 1;
}

void SizeGraph::spread(std::size_t from) {
  spread_in_grid(from);
  const auto index = static_cast<Index>(from);
  const auto before = [](const auto& link, Index i) { return link.first < i; };
  auto link = std::lower_bound(links_.begin(), links_.end(), index, before);
  for (; link != links_.end() && link->first == index; ++link) relax(from, link->second);
  auto way = std::lower_bound(across_.begin(), across_.end(), index, before);
  for (; way != across_.end() && way->first == index; ++way) {
    const auto& [to, turn] = way->second;
    const SizeTensor carried = turn(points_[from].size);
    lower(to, bounded_minimum(points_[to].size, carried), kLeastFallAcross);
  }
}

void SizeGraph::spread_in_grid(std::size_t from) {
  auto grid = std::upper_bound(grids_.begin(), grids_.end(), from,
                               [](std::size_t i, const Grid& g) { return i < g.first; });
  if (grid == grids_.begin()) return;
  --grid;
  const int place = static_cast<int>(from - grid->first);
  if (place >= grid->columns * grid->rows) return;
  const int column = place % grid->columns, row = place / grid->columns;
  for (int j = std::max(-kReach, -row); j <= std::min(kReach, grid->rows - 1 - row); ++j) {
    for (int i = std::max(-kReach, -column); i <= std::min(kReach, grid->columns - 1 - column);
         ++i) {
      if (std::gcd(i, j) != 1) continue;
      relax(from, grid->first + static_cast<std::size_t>((row + j) * grid->columns + column + i));
    }
  }
}

void SizeGraph::relax(std::size_t from, std::size_t to) {
  const SizedPoint &start = points_[from], &end = points_[to];
  const Vec3 step = end.frame.point - start.frame.point;
  const double distance = step.norm();
  const Range sizes = range_of(start.size);
  const double greatest = range_of(end.size).greatest;
  // No direction is shorter than that of the greater length.
  if (greatest <= sizes.least * (1 + growth_ * distance / sizes.greatest)) return;
  const double length = length_m(from, step, distance);
  if (greatest <= sizes.least * (1 + growth_ * length)) return;
  lower(to, bounded_minimum(end.size, scaled(start.size, 1 + growth_ * length)), kLeastFall);
}

void SizeGraph::lower(std::size_t point, const SizeTensor& size, double least_fall) {
  SizeTensor& own = points_[point].size;
  const double trace = own.h11 + own.h22;
  if (trace - (size.h11 + size.h22) <= least_fall * trace) return;
  own = size;
  push(point);
}

/// Metric length of a chord, laid down into the tangent plane of its start.
double SizeGraph::length_m(std::size_t from, const Vec3& step, double distance) const {
  const auto& [frame, h] = points_[from];
  const double x = step.dot(frame.first), y = step.dot(frame.second);
  const double projected = std::sqrt(x * x + y * y);
  if (!(projected > 0)) return distance / range_of(h).greatest;
  const double scale = distance / (projected * determinant(h));
  const double along = h.h22 * x - h.h12 * y, across = h.h11 * y - h.h12 * x;
  return scale * std::sqrt(along * along + across * across);
}

}  // namespace surfmesh::judge
