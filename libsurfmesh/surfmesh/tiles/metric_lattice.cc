// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/metric_lattice.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh::detail {

MetricLattice::MetricLattice(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                             const MetricField& field)
    : box_(box_of(polygon, nodes)), densities_(kSide * kSide, 0) {
  QueryHint hint;
  double steps_u = 0, steps_v = 0;
  std::size_t count = 0;
  for_each_inside(polygon, nodes, [&](std::size_t column, std::size_t row) {
    const Metric metric = field.at(centre(column, row), hint);
    const double sample = density(metric);
    if (!std::isfinite(sample)) return;
    densities_[row * kSide + column] = sample;
    area_ += sample;
    steps_u += std::sqrt(metric.m11);
    steps_v += std::sqrt(metric.m22);
    ++count;
  });
  queries_ = hint.answers;
  if (count == 0) return;
  const double share = 1 / static_cast<double>(count);
  extents_ = {share * steps_u * (box_.upper.u - box_.lower.u),
              share * steps_v * (box_.upper.v - box_.lower.v)};
}

double MetricLattice::coordinate_at(int axis, double share) const {
  std::array<double, kSide> sums{};
  for (std::size_t row = 0; row < kSide; ++row) {
    for (std::size_t column = 0; column < kSide; ++column) {
      sums[axis == 0 ? column : row] += densities_[row * kSide + column];
    }
  }
  double left = share * area_;
  std::size_t cell = 0;
  while (cell + 1 < kSide && sums[cell] < left) left -= sums[cell++];
  const double within = sums[cell] > 0 ? std::min(1.0, left / sums[cell]) : 0.5;
  const double place = (static_cast<double>(cell) + within) / kSide;
  const Uv uv = {box_.lower.u + place * (box_.upper.u - box_.lower.u),
                 box_.lower.v + place * (box_.upper.v - box_.lower.v)};
  return axis == 0 ? uv.u : uv.v;
}

double MetricLattice::area_in(const TilePolygon& part, const std::vector<TileNode>& nodes) const {
  double sum = 0;
  for_each_inside(part, nodes, [&](std::size_t column, std::size_t row) {
    sum += densities_[row * kSide + column];
  });
  return sum;
}

/// Call `visit(column, row)` for the cells whose centres lie inside a polygon, row by row.
template <class Visit>
void MetricLattice::for_each_inside(const TilePolygon& polygon, const std::vector<TileNode>& nodes,
                                    Visit visit) const {
  auto ends = ends_of_rows(polygon, nodes);
  for (std::size_t row = 0; row < kSide; ++row) {
    std::sort(ends[row].begin(), ends[row].end());
    for (std::size_t i = 0; i + 1 < ends[row].size(); i += 2) {
      const std::size_t end = cells_before(0, ends[row][i + 1]);
      for (std::size_t column = cells_before(0, ends[row][i]); column < end; ++column) {
        visit(column, row);
      }
    }
  }
}

/// Where each row enters and leaves a polygon, unsorted. Each side is looked at once.
std::array<std::vector<double>, MetricLattice::kSide> MetricLattice::ends_of_rows(
    const TilePolygon& polygon, const std::vector<TileNode>& nodes) const {
  std::array<std::vector<double>, kSide> ends;
  for_each_side(polygon, [&](SidePlace place) {
    Uv a = nodes[static_cast<std::size_t>(at(polygon, place).node)].uv;
    Uv b = nodes[static_cast<std::size_t>(at(polygon, next(polygon, place)).node)].uv;
    if (a.v > b.v) std::swap(a, b);
    const std::size_t end = cells_before(1, b.v);
    for (std::size_t row = cells_before(1, a.v); row < end; ++row) {
      ends[row].push_back(a.u + (centre(0, row).v - a.v) / (b.v - a.v) * (b.u - a.u));
    }
  });
  return ends;
}

/// The number of columns (0) or rows (1) whose centres lie before a coordinate.
std::size_t MetricLattice::cells_before(int axis, double coordinate) const {
  const double lower = axis == 0 ? box_.lower.u : box_.lower.v;
  const double upper = axis == 0 ? box_.upper.u : box_.upper.v;
  if (!(upper > lower)) return 0;
  const double cells = std::ceil((coordinate - lower) / (upper - lower) * kSide - 0.5);
  return static_cast<std::size_t>(std::clamp(cells, 0.0, static_cast<double>(kSide)));
}

Uv MetricLattice::centre(std::size_t column, std::size_t row) const {
  const double u = (static_cast<double>(column) + 0.5) / kSide;
  const double v = (static_cast<double>(row) + 0.5) / kSide;
  return {box_.lower.u + u * (box_.upper.u - box_.lower.u),
          box_.lower.v + v * (box_.upper.v - box_.lower.v)};
}

}  // namespace surfmesh::detail
