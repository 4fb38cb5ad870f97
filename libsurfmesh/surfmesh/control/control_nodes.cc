// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_nodes.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <numeric>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Cells are intervals of a grid of this many lines, so that neighbours share corners exactly.
constexpr std::uint32_t kGridSize = 1u << 24;

/// The first cells: so many along each side, for a field of which the samples of one cell would
/// see too little.
constexpr std::uint32_t kFirstCells = 4;

/// Shares of a cell's width at which it is sampled: irrational, and not symmetric.
constexpr std::array<double, 3> kSampleShares = {0.1273, 0.4817, 0.8359};

/// Nodes for each unit of metric area, of which an element takes 0.43, and beside these, from which on
/// no cell is halved. Smooth fields take less than one a unit, creased patches of a few elements
/// hundreds in all.
constexpr double kMostNodesPerUnit = 8;
constexpr double kFreeNodes = 20'000;

/// The precision for which these are: inverse distances need nodes as its inverse square.
constexpr double kUsualPrecision = 0.1;

/// Nodes in all: far more than sizes that elements can follow ever need in one patch.
constexpr double kMostNodes = 4e6;

struct Cell {
  std::uint32_t i0, j0, i1, j1;
  std::vector<int> places = {};  ///< those of sources inside
  double metric_area = 0;        ///< as the cell it comes from shows it
};

/// Samples of the field inside one cell, rows along u.
using CellSamples = std::array<std::array<SizeField::Sample, 3>, 3>;

class NodeChooser {
 public:
  NodeChooser(const SizeField& field, const ControlNodeOptions& options)
      : field_(field),
        domain_(field.surface().domain()),
        options_(options),
        finer_(options.by_distance
                   ? std::max(1.0, std::pow(kUsualPrecision / options.precision, 2))
                   : 1.0) {}

  ChosenNodes run() {
    constexpr std::uint32_t step = kGridSize / kFirstCells;
    // First come, first served: where nodes are cut off, all cells are equally fine.
    std::deque<Cell> cells;
    for (std::uint32_t j = 0; j < kGridSize; j += step)
      for (std::uint32_t i = 0; i < kGridSize; i += step)
        cells.push_back({i, j, i + step, j + step});
    const std::vector<int> all = all_places();
    for (Cell& cell : cells) take_places(cell, all);
    while (!cells.empty()) {
      const Cell cell = std::move(cells.front());
      cells.pop_front();
      split_or_keep(cell, cells);
    }
    return {std::move(nodes_), is_coarse_};
  }

 private:
  Uv at(double i, double j) const { return domain_.at(i / kGridSize, j / kGridSize); }

  ControlNode& node(std::uint32_t i, std::uint32_t j) {
    const std::uint64_t key = std::uint64_t{i} << 32 | j;
    const auto [entry, is_new] = index_.try_emplace(key, nodes_.size());
    if (is_new) {
      const Uv uv = at(i, j);
      const SizeField::Sample sample = field_.at(uv);
      nodes_.push_back({uv, sample.point, sample.form, sample.size, {0, 0, 0}});
    }
    return nodes_[entry->second];
  }

  /// Metric area of a cell by the mean of its samples, which take the place of what its parent showed.
  void measure(Cell& cell, const CellSamples& samples) {
    double density = 0;
    for (const auto& row : samples) {
      for (const SizeField::Sample& s : row) {
        density += s.form.l11 * s.form.l22 / determinant(s.size) / 9;
      }
    }
    metric_area_ -= cell.metric_area;
    cell.metric_area = density * (domain_.u1 - domain_.u0) * (domain_.v1 - domain_.v0) *
                       (cell.i1 - cell.i0) / kGridSize * (cell.j1 - cell.j0) / kGridSize;
    metric_area_ += cell.metric_area;
  }

  bool is_cut_off() {
    const double most = std::min(kMostNodes, finer_ * (kFreeNodes + kMostNodesPerUnit * metric_area_));
    const bool is_over = static_cast<double>(nodes_.size()) > most;
    is_coarse_ = is_coarse_ || is_over;
    return is_over;
  }

  CellSamples sample(const Cell& cell) const {
    CellSamples samples;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        samples[row][column] = field_.at(position(cell, row, column));
      }
    }
    return samples;
  }

  Uv position(const Cell& cell, std::size_t row, std::size_t column) const {
    // Each row is shifted, so that no line of constant u or v holds three samples.
    const double s = kSampleShares[column] + 0.017 * static_cast<double>(row);
    const double t = kSampleShares[row] + 0.013 * static_cast<double>(column);
    return at(cell.i0 + s * (cell.i1 - cell.i0), cell.j0 + t * (cell.j1 - cell.j0));
  }

  void split_or_keep(Cell cell, std::deque<Cell>& cells) {
    const std::array<ControlNode, 4> corners = {node(cell.i0, cell.j0), node(cell.i1, cell.j0),
                                                node(cell.i1, cell.j1), node(cell.i0, cell.j1)};
    const CellSamples samples = sample(cell);
    measure(cell, samples);
    const bool can_split_u = is_long(cell, samples, true);
    const bool can_split_v = is_long(cell, samples, false);
    if ((can_split_u || can_split_v) && !conforms(cell, corners, samples) && !is_cut_off()) {
      split(cell,
            can_split_u && (!can_split_v || variation(samples, true) >= variation(samples, false)),
            cells);
      return;
    }
    const Missed missed = missed_place(cell, corners);
    if (missed.is_any && !is_cut_off()) {
      split(cell, missed.is_longer_along_u, cells);
    } else {
      keep(cell);
    }
  }

  void split(const Cell& cell, bool along_u, std::deque<Cell>& cells) const {
    Cell first{cell.i0, cell.j0, cell.i1, cell.j1, {}, 0.5 * cell.metric_area};
    Cell second = first;
    if (along_u) {
      first.i1 = second.i0 = cell.i0 + (cell.i1 - cell.i0) / 2;
    } else {
      first.j1 = second.j0 = cell.j0 + (cell.j1 - cell.j0) / 2;
    }
    take_places(first, cell.places);
    take_places(second, cell.places);
    cells.push_back(std::move(first));
    cells.push_back(std::move(second));
  }

  std::vector<int> all_places() const {
    std::vector<int> all(field_.places().size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  void take_places(Cell& cell, const std::vector<int>& places) const {
    const Uv lower = at(cell.i0, cell.j0), upper = at(cell.i1, cell.j1);
    for (const int place : places) {
      const Uv uv = field_.places()[static_cast<std::size_t>(place)];
      if (uv.u >= lower.u && uv.u <= upper.u && uv.v >= lower.v && uv.v <= upper.v) {
        cell.places.push_back(place);
      }
    }
  }

  /// Whether the cell hides a place of a source, and its longer side in the sizes there.
  struct Missed {
    bool is_any = false;
    bool is_longer_along_u = false;
  };

  Missed missed_place(const Cell& cell, const std::array<ControlNode, 4>& corners) const {
    const Uv u_step{(domain_.u1 - domain_.u0) * (cell.i1 - cell.i0) / kGridSize, 0};
    const Uv v_step{0, (domain_.v1 - domain_.v0) * (cell.j1 - cell.j0) / kGridSize};
    for (const int place : cell.places) {
      const Uv uv = field_.places()[static_cast<std::size_t>(place)];
      const SizeField::Sample exact = field_.at(uv);
      const Metric metric = metric_from_size(exact.form, exact.size);
      const double along_u = squared_length(metric, u_step);
      const double along_v = squared_length(metric, v_step);
      // A cell of few grid lines is left as it is, whatever is asked for in it.
      const bool is_long = std::max(along_u, along_v) > kLeastCellLength * kLeastCellLength &&
                           std::min(cell.i1 - cell.i0, cell.j1 - cell.j0) > 1;
      if (!is_long || log_conformity(exact.size, from_corners(corners, uv, exact)) <= options_.precision) {
        continue;
      }
      return {true, along_u >= along_v};
    }
    return {};
  }

  /// Tell the corners of a cell how far their neighbours are: those of the finest cell count.
  void keep(const Cell& cell) {
    const double width = (domain_.u1 - domain_.u0) * (cell.i1 - cell.i0) / kGridSize;
    const double height = (domain_.v1 - domain_.v0) * (cell.j1 - cell.j0) / kGridSize;
    for (const std::uint32_t i : {cell.i0, cell.i1}) {
      for (const std::uint32_t j : {cell.j0, cell.j1}) {
        Metric& spacing = node(i, j).spacing;
        spacing.m11 = std::max(spacing.m11, 1 / (width * width));
        spacing.m22 = std::max(spacing.m22, 1 / (height * height));
      }
    }
  }

  bool conforms(const Cell& cell, const std::array<ControlNode, 4>& corners,
                const CellSamples& samples) const {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        const SizeField::Sample& exact = samples[row][column];
        const SizeTensor interpolated = from_corners(corners, position(cell, row, column), exact);
        if (!(log_conformity(exact.size, interpolated) <= options_.precision)) return false;
      }
    }
    return true;
  }

  /// What the triangle gives at a sample if the cell is cut along its rising diagonal.
  SizeTensor from_corners(const std::array<ControlNode, 4>& corners, Uv uv,
                          const SizeField::Sample& sample) const {
    const bool is_below =
        cross(corners[2].uv - corners[0].uv, uv - corners[0].uv) < 0;
    const std::array<const ControlNode*, 3> nodes = {&corners[0], &corners[is_below ? 1 : 2],
                                                     &corners[is_below ? 2 : 3]};
    std::array<SizeTensor, 3> sizes;
    for (std::size_t k = 0; k < 3; ++k) sizes[k] = nodes[k]->size;
    if (!options_.by_distance) {
      return interpolate_linearly(sizes, {nodes[0]->uv, nodes[1]->uv, nodes[2]->uv}, uv);
    }
    std::array<double, 3> distances{};
    for (std::size_t k = 0; k < 3; ++k) {
      distances[k] = squared_distance(sample.form, uv - nodes[k]->uv);
    }
    return interpolate(sizes, distances);
  }

  /// True if the cell is not yet small against the elements wanted in it.
  bool is_long(const Cell& cell, const CellSamples& samples, bool along_u) const {
    const double width = (domain_.u1 - domain_.u0) * (cell.i1 - cell.i0) / kGridSize;
    const double height = (domain_.v1 - domain_.v0) * (cell.j1 - cell.j0) / kGridSize;
    const Uv step = along_u ? Uv{width, 0} : Uv{0, height};
    const std::uint32_t lines = along_u ? cell.i1 - cell.i0 : cell.j1 - cell.j0;
    if (lines < 2) return false;
    for (const auto& row : samples) {
      for (const SizeField::Sample& s : row) {
        const double squared = squared_length(metric_from_size(s.form, s.size), step);
        if (squared > kLeastCellLength * kLeastCellLength) return true;
      }
    }
    return false;
  }

  /// Greatest change of the field between samples of one row (or column).
  static double variation(const CellSamples& samples, bool along_u) {
    double greatest = 0;
    for (std::size_t line = 0; line < 3; ++line) {
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& a = along_u ? samples[line][k] : samples[k][line];
        const auto& b = along_u ? samples[line][k + 1] : samples[k + 1][line];
        greatest = std::max(greatest, log_conformity(a.size, b.size));
      }
    }
    return greatest;
  }

  const SizeField& field_;
  Domain domain_;
  const ControlNodeOptions& options_;
  double finer_;  ///< nodes for each that the usual precision takes
  std::vector<ControlNode> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> index_;
  double metric_area_ = 0;  ///< of all cells
  bool is_coarse_ = false;
};

std::vector<ControlNode> regular_nodes(const SizeField& field, int count) {
  const Domain domain = field.surface().domain();
  if (count > kMostNodes) {
    throw Error(ErrorCode::Limit, fmt::format("{} control nodes in one patch are more than {}",
                                              count, kMostNodes));
  }
  const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(count))));
  const double width = (domain.u1 - domain.u0) / (side - 1);
  const double height = (domain.v1 - domain.v0) / (side - 1);
  const Metric spacing{1 / (width * width), 0, 1 / (height * height)};
  std::vector<ControlNode> nodes;
  nodes.reserve(static_cast<std::size_t>(side * side));
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const Uv uv = domain.at(double(i) / (side - 1), double(j) / (side - 1));
      const SizeField::Sample sample = field.at(uv);
      nodes.push_back({uv, sample.point, sample.form, sample.size, spacing});
    }
  }
  return nodes;
}

}  // namespace

void check(const ControlNodeOptions& options) {
  if (options.regular < 0 || (options.regular > 0 && options.regular < 4)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("nodes = {} is outside its range: auto, or 4 and above", options.regular));
  }
  if (!(options.precision > 0)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("precision = {} is outside its range: above 0", options.precision));
  }
}

ChosenNodes choose_control_nodes(const SizeField& field,
                                              const ControlNodeOptions& options) {
  check(options);
  if (options.regular > 0) return {regular_nodes(field, options.regular)};
  return NodeChooser(field, options).run();
}

}  // namespace surfmesh
