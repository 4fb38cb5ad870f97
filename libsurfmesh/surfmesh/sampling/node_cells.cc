// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/node_cells.hh"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::detail {
namespace {

/// Cells are intervals of a grid of this many lines, so that neighbours share corners exactly.
constexpr std::uint32_t kGridSize = 1u << 24;

/// The first cells: so many along each side, for a field of which the samples of one cell would
/// see too little.
constexpr std::uint32_t kFirstCells = 4;

/// Shares of a cell's width at which it is sampled: irrational, and not symmetric.
constexpr std::array<double, 3> kSampleShares = {0.1273, 0.4817, 0.8359};
/// Each row is shifted, so that no line of constant u or v holds three samples.
constexpr double kShiftAlongU = 0.017, kShiftAlongV = 0.013;
/// Where the middle one of three samples in a line lies between the others.
constexpr double kMiddleShare =
    (kSampleShares[1] - kSampleShares[0]) / (kSampleShares[2] - kSampleShares[0]);

/// What is missed at most along a line of a cell for each that it changes between the samples in
/// that line: 1.8 for a field of second order.
constexpr double kErrorPerChange = 2;

/// A change below this share of that along the other direction comes from the shifts of the rows.
constexpr double kCrossTalk = 0.25;

/// Changes below this share of what is missed tell no direction.
constexpr double kEvenShare = 0.1;

/// The precision for which most_nodes() is: inverse distances need nodes as its inverse square.
constexpr double kUsualPrecision = 0.1;

/// Nodes in all: far more than sizes that elements can follow ever need in one patch.
constexpr double kMostNodes = 4e6;

bool is_long(double squared_length) { return squared_length > kLeastCellLength * kLeastCellLength; }

}  // namespace

NodeCells::NodeCells(const SizeField& field, bool by_distance)
    : field_(field), domain_(field.surface().domain()), by_distance_(by_distance) {
  for (const Uv uv : field.required_points()) points_.push_back(field.at(uv));
  std::vector<std::size_t> all(points_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  constexpr std::uint32_t step = kGridSize / kFirstCells;
  for (std::uint32_t j = 0; j < kGridSize; j += step) {
    for (std::uint32_t i = 0; i < kGridSize; i += step) {
      Cell& cell = cells_.emplace_back(Cell{i, j, i + step, j + step});
      cell.corners = {node(cell.i0, cell.j0), node(cell.i1, cell.j0), node(cell.i1, cell.j1),
                      node(cell.i0, cell.j1)};
      add_points(cell, all);
      examine(cell);
    }
  }
}

bool NodeCells::refine(double precision) {
  // First come, first served: where there are too many nodes, all cells are equally fine.
  std::deque<Cell> waiting(std::make_move_iterator(cells_.begin()),
                           std::make_move_iterator(cells_.end()));
  cells_.clear();
  bool is_held = true;
  while (!waiting.empty()) {
    Cell cell = std::move(waiting.front());
    waiting.pop_front();
    const bool conforms = cell.halving.error <= precision;
    if (conforms || is_full(precision)) {
      is_held = is_held && conforms;
      cells_.push_back(std::move(cell));
    } else {
      halve(cell, waiting);
    }
  }
  return is_held;
}

std::vector<ControlNode> NodeCells::nodes() const {
  std::vector<ControlNode> result = nodes_;
  for (const Cell& cell : cells_) {
    const Uv size = extent(cell);
    for (const std::size_t corner : cell.corners) {
      Metric& spacing = result[corner].spacing;
      spacing.m11 = std::max(spacing.m11, 1 / (size.u * size.u));
      spacing.m22 = std::max(spacing.m22, 1 / (size.v * size.v));
    }
  }
  return result;
}

Uv NodeCells::at(double i, double j) const { return domain_.at(i / kGridSize, j / kGridSize); }

Uv NodeCells::extent(const Cell& cell) const {
  return {(domain_.u1 - domain_.u0) * (cell.i1 - cell.i0) / kGridSize,
          (domain_.v1 - domain_.v0) * (cell.j1 - cell.j0) / kGridSize};
}

/// The node at a crossing of grid lines, made where there is none.
std::size_t NodeCells::node(std::uint32_t i, std::uint32_t j) {
  const std::uint64_t key = std::uint64_t{i} << 32 | j;
  const auto [entry, is_new] = index_.try_emplace(key, nodes_.size());
  if (is_new) {
    const Uv uv = at(i, j);
    const SizeField::Sample sample = field_.at(uv);
    nodes_.push_back({uv, sample.point, sample.form, sample.size, {0, 0, 0}});
  }
  return entry->second;
}

void NodeCells::examine(Cell& cell) {
  const CellSamples samples = sample(cell);
  measure(cell, samples);
  const Halving by_samples = halving_by_samples(cell, samples);
  const Halving by_places = halving_by_points(cell);
  cell.halving = by_samples.error >= by_places.error ? by_samples : by_places;
}

NodeCells::CellSamples NodeCells::sample(const Cell& cell) const {
  CellSamples samples;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const double s = kSampleShares[column] + kShiftAlongU * static_cast<double>(row);
      const double t = kSampleShares[row] + kShiftAlongV * static_cast<double>(column);
      const Uv uv = at(cell.i0 + s * (cell.i1 - cell.i0), cell.j0 + t * (cell.j1 - cell.j0));
      samples.at[row][column] = uv;
      samples.field[row][column] = field_.at(uv);
    }
  }
  return samples;
}

/// Metric area of a cell by the mean of its samples, which take the place of what its parent
/// showed.
void NodeCells::measure(Cell& cell, const CellSamples& samples) {
  double density = 0;
  for (const auto& row : samples.field) {
    for (const SizeField::Sample& s : row) {
      density += s.form.l11 * s.form.l22 / determinant(s.size) / 9;
    }
  }
  const Uv size = extent(cell);
  metric_area_ -= cell.metric_area;
  cell.metric_area = density * size.u * size.v;
  metric_area_ += cell.metric_area;
}

/// Across the direction in which there is most to mend. Where the cell is small along it, halving
/// along the other one mends no more than what there is along that.
NodeCells::Halving NodeCells::halving_by_samples(const Cell& cell,
                                                 const CellSamples& samples) const {
  const Uv size = extent(cell);
  Table<double> errors;
  double error = 0, along_u = 0, along_v = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const SizeField::Sample& exact = samples.field[row][column];
      const Metric metric = metric_from_size(exact.form, exact.size);
      along_u = std::max(along_u, squared_length(metric, {size.u, 0}));
      along_v = std::max(along_v, squared_length(metric, {0, size.v}));
      errors[row][column] = error_at(cell, samples.at[row][column], exact);
      error = std::max(error, errors[row][column]);
    }
  }
  const bool is_long_u = is_long(along_u) && cell.i1 - cell.i0 > 1;
  const bool is_long_v = is_long(along_v) && cell.j1 - cell.j0 > 1;
  if (!is_long_u && !is_long_v) return {};
  const double change_u = change(errors, samples, true), change_v = change(errors, samples, false);
  const bool is_even = std::max(change_u, change_v) < kEvenShare * error;
  const bool is_more_u = is_even ? along_u >= along_v : change_u >= change_v;
  if (is_more_u ? is_long_u : is_long_v) return {error, is_more_u};
  const auto [less, more] = std::minmax(change_u, change_v);
  if (less < kCrossTalk * more) return {};
  return {std::min(error, kErrorPerChange * less), !is_more_u};
}

/// Across the longer side of the cell in the sizes at the point of a source that it hides most.
NodeCells::Halving NodeCells::halving_by_points(const Cell& cell) const {
  const Uv size = extent(cell);
  Halving halving;
  // A cell of few grid lines is left as it is, whatever is asked for in it.
  if (std::min(cell.i1 - cell.i0, cell.j1 - cell.j0) < 2) return halving;
  for (const std::size_t point : cell.points) {
    const SizeField::Sample& exact = points_[point];
    const Metric metric = metric_from_size(exact.form, exact.size);
    const double along_u = squared_length(metric, {size.u, 0});
    const double along_v = squared_length(metric, {0, size.v});
    if (!is_long(std::max(along_u, along_v))) continue;
    const double error = error_at(cell, field_.required_points()[point], exact);
    if (error > halving.error) halving = {error, along_u >= along_v};
  }
  return halving;
}

/// What is missed at a point by the triangle that holds it if the cell is cut along its rising
/// diagonal.
double NodeCells::error_at(const Cell& cell, Uv uv, const SizeField::Sample& exact) const {
  const ControlNode& first = nodes_[cell.corners[0]];
  const bool is_below = cross(nodes_[cell.corners[2]].uv - first.uv, uv - first.uv) < 0;
  const ControlNode& second = nodes_[cell.corners[is_below ? 1 : 2]];
  const ControlNode& third = nodes_[cell.corners[is_below ? 2 : 3]];
  const std::array<SizeTensor, 3> sizes = {first.size, second.size, third.size};
  const std::array<Uv, 3> corners = {first.uv, second.uv, third.uv};
  if (!by_distance_) return log_conformity(exact.size, interpolate_linearly(sizes, corners, uv));
  std::array<double, 3> distances{};
  for (std::size_t k = 0; k < 3; ++k) {
    distances[k] = squared_distance(exact.form, uv - corners[k]);
  }
  return log_conformity(exact.size, interpolate(sizes, distances));
}

/// How much there is to mend along a direction: the greatest change, between the samples in a line,
/// of what is missed, or how far the middle one is from linear between the others, where that is
/// more: of a field that turns fast all samples miss the same. By distance, which does not follow
/// even a linear field, the change of the field from each to the next.
double NodeCells::change(const Table<double>& errors, const CellSamples& samples,
                         bool along_u) const {
  double greatest = 0;
  for (std::size_t line = 0; line < 3; ++line) {
    const auto in_line = [&](const auto& table, std::size_t k) -> const auto& {
      return along_u ? table[line][k] : table[k][line];
    };
    const auto size = [&](std::size_t k) -> const SizeTensor& {
      return in_line(samples.field, k).size;
    };
    if (by_distance_) {
      greatest =
          std::max({greatest, log_conformity(size(0), size(1)), log_conformity(size(1), size(2))});
      continue;
    }
    const auto [least, most] =
        std::minmax({in_line(errors, 0), in_line(errors, 1), in_line(errors, 2)});
    const double bend = log_conformity(size(1), lerp(size(0), size(2), kMiddleShare));
    greatest = std::max({greatest, most - least, bend});
  }
  return greatest;
}

void NodeCells::halve(const Cell& cell, std::deque<Cell>& cells) {
  Cell first{cell.i0, cell.j0, cell.i1, cell.j1, cell.corners, {}, 0.5 * cell.metric_area, {}};
  Cell second = first;
  const auto& [lower_left, lower_right, upper_right, upper_left] = cell.corners;
  if (cell.halving.is_along_u) {
    first.i1 = second.i0 = cell.i0 + (cell.i1 - cell.i0) / 2;
    const std::size_t lower = node(first.i1, cell.j0), upper = node(first.i1, cell.j1);
    first.corners = {lower_left, lower, upper, upper_left};
    second.corners = {lower, lower_right, upper_right, upper};
  } else {
    first.j1 = second.j0 = cell.j0 + (cell.j1 - cell.j0) / 2;
    const std::size_t left = node(cell.i0, first.j1), right = node(cell.i1, first.j1);
    first.corners = {lower_left, lower_right, right, left};
    second.corners = {left, right, upper_right, upper_left};
  }
  for (Cell* half : {&first, &second}) {
    add_points(*half, cell.points);
    examine(*half);
    cells.push_back(std::move(*half));
  }
}

void NodeCells::add_points(Cell& cell, const std::vector<std::size_t>& points) const {
  const Uv lower = at(cell.i0, cell.j0), upper = at(cell.i1, cell.j1);
  for (const std::size_t point : points) {
    const Uv uv = field_.required_points()[point];
    if (uv.u >= lower.u && uv.u <= upper.u && uv.v >= lower.v && uv.v <= upper.v) {
      cell.points.push_back(point);
    }
  }
}

bool NodeCells::is_full(double precision) const {
  const double finer = by_distance_ ? std::max(1.0, std::pow(kUsualPrecision / precision, 2)) : 1.0;
  const double most = std::min(kMostNodes, finer * surfmesh::most_nodes(metric_area_));
  return static_cast<double>(nodes_.size()) > most;
}

}  // namespace surfmesh::detail
