// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/accurate_nodes.hh"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/geometry/quasirandom.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sampling/node_cells.hh"

namespace surfmesh {
namespace {

/// Greatest relative error of ∫√det M before gradation. The mark is 2 %; the estimate itself is
/// good to some tenths of a percent.
constexpr double kAreaError = 0.015;

/// Error of the integral that is no matter even in a patch smaller than one element: a tenth of a
/// triangle.
constexpr double kNegligibleArea = 0.05;

/// Finer precisions that are tried, each by this factor.
constexpr int kMaxRounds = 6;
constexpr double kFinerPrecision = 0.6;

/// Nodes along a side of the first grid, and in all.
constexpr int kFirstGridSide = 9;
constexpr double kMostGridNodes = 1.1e6;

/// Points at least that a grid is compared at, and the share of them that may miss the precision:
/// half of what PrecisionSample takes for held.
constexpr int kLeastGridPoints = 300;
constexpr double kHeldMissing = 0.01;

/// Points of the independent sample: as many as nodes, within bounds.
int sample_count(std::size_t nodes) {
  return static_cast<int>(std::clamp<std::size_t>(nodes, 300, 100'000));
}

double root_of_determinant(const FirstFormFactor& form, const SizeTensor& size) {
  return form.l11 * form.l22 / determinant(size);
}

/// True if a point of the rectangle lies in the domain, which may be a triangle.
bool is_in(const Domain& domain, Uv uv) { return domain.fold(uv) == uv; }

/// Points that cover the domain of a field evenly, and the exact field at them: as many as have
/// been asked for.
class EvenSample {
 public:
  struct Point {
    Uv uv;
    SizeField::Sample field;
  };

  explicit EvenSample(const SizeField& field) : field_(field) {}

  /// The points among the first `count` of the rectangle that lie in the domain.
  std::span<const Point> first(int count) {
    const Domain domain = field_.surface().domain();
    while (std::ssize(sizes_) < count) {
      const Uv uv = quasirandom_point(domain, static_cast<int>(sizes_.size()) + 1);
      if (is_in(domain, uv)) points_.push_back({uv, field_.at(uv)});
      sizes_.push_back(points_.size());
    }
    return std::span(points_).first(count > 0 ? sizes_[static_cast<std::size_t>(count) - 1] : 0);
  }

  const SizeField& field() const { return field_; }

 private:
  const SizeField& field_;
  std::vector<Point> points_;
  std::vector<std::size_t> sizes_;  ///< of `points_` after each point of the rectangle
};

MetricArea metric_area(EvenSample& sample, const ControlSpace& control, int samples) {
  const Domain domain = sample.field().surface().domain();
  const double cell = (domain.u1 - domain.u0) * (domain.v1 - domain.v0) / samples;
  MetricArea area;
  QueryHint hint;
  for (const auto& [uv, field] : sample.first(samples)) {
    area.exact += cell * root_of_determinant(field.form, field.size);
    area.control +=
        cell * root_of_determinant(field.form, control.size({uv, field.point, field.form}, hint));
  }
  return area;
}

/// Metric area of the rectangle of a domain, by the mean of regular nodes.
double area_by_nodes(const Surface& surface, const std::vector<ControlNode>& nodes) {
  const Domain domain = surface.domain();
  double sum = 0;
  for (const ControlNode& node : nodes) sum += root_of_determinant(node.form, node.size);
  return (domain.u1 - domain.u0) * (domain.v1 - domain.v0) * sum /
         static_cast<double>(nodes.size());
}

/// Compares a grid of control nodes with the field at quasi-random points.
class GridSample {
 public:
  GridSample(const ControlGrid& grid, const SizeField& field, double precision)
      : grid_(grid),
        field_(field),
        precision_(precision),
        u_step_{grid.cell_extent(0).u, 0},
        v_step_{0, grid.cell_extent(0).v} {}

  /// The share of points that miss the precision: of twice as many as nodes.
  double missing_share(const RunContext& context) {
    const int points = std::max(kLeastGridPoints, 2 * grid_.node_count());
    int missing = 0;
    for (int i = 1; i <= points; ++i) {
      if (static_cast<std::size_t>(i) % kStepsBetweenCancellation == 0)
        context.throw_if_cancelled();
      missing += misses(quasirandom_point(field_.surface().domain(), i)) ? 1 : 0;
    }
    return static_cast<double>(missing) / points;
  }

  /// True if the grid holds the places of sources, however small the part of the domain is in which
  /// they ask for a size.
  bool holds_required_points() {
    const std::vector<Uv>& points = field_.required_points();
    return std::none_of(points.begin(), points.end(), [this](Uv uv) { return misses(uv); });
  }

 private:
  /// True if the grid misses the precision at a point where it is no finer than the elements.
  bool misses(Uv uv) {
    if (!is_in(field_.surface().domain(), uv)) return false;
    const SizeField::Sample exact = field_.at(uv);
    const Metric metric = metric_from_size(exact.form, exact.size);
    const double cell = std::max(squared_length(metric, u_step_), squared_length(metric, v_step_));
    if (cell < kLeastCellLength * kLeastCellLength) return false;
    const SizeTensor size = grid_.size({uv, exact.point, exact.form}, hint_);
    return !(log_conformity(exact.size, size) <= precision_);
  }

  const ControlGrid& grid_;
  const SizeField& field_;
  double precision_;
  Uv u_step_;
  Uv v_step_;
  QueryHint hint_;
};

}  // namespace

MetricArea metric_area(const SizeField& field, const ControlSpace& control, int samples) {
  EvenSample sample(field);
  return metric_area(sample, control, samples);
}

ChosenNodes choose_accurate_nodes(const SizeField& field, const ControlNodeOptions& options) {
  check(options);
  if (options.regular > 0 || !field.has_source()) return choose_control_nodes(field, options);
  const Interpolation interpolation =
      options.by_distance ? Interpolation::Triangle : Interpolation::Linear;
  detail::NodeCells cells(field, options.by_distance);
  EvenSample sample(field);
  double precision = options.precision;
  bool is_full = !cells.refine(precision);
  ChosenNodes chosen{cells.nodes(), is_full};
  for (int round = 0; round < kMaxRounds && !is_full; ++round) {
    const ControlMesh control(field.surface().domain(), chosen.nodes,
                              {.interpolation = interpolation});
    const MetricArea area = metric_area(sample, control, sample_count(chosen.nodes.size()));
    const double error = std::abs(area.control - area.exact);
    if (error <= std::max(kNegligibleArea, kAreaError * area.exact)) break;
    precision *= kFinerPrecision;
    is_full = !cells.refine(precision);  // what was asked for is held all the same
    chosen.nodes = cells.nodes();
  }
  return chosen;
}

ChosenNodes choose_grid_nodes(const SizeField& field, const ControlNodeOptions& options,
                              const RunContext& context) {
  if (options.regular > 0) return choose_control_nodes(field, options);
  for (int side = kFirstGridSide;; side = 2 * side - 1) {
    context.throw_if_cancelled();
    ChosenNodes chosen = choose_control_nodes(field, {.regular = side * side});
    const ControlGrid grid(field.surface().domain(), chosen.nodes, {});
    GridSample sample(grid, field, options.precision);
    if (sample.missing_share(context) <= kHeldMissing && sample.holds_required_points()) {
      return chosen;
    }
    const double most =
        std::min(kMostGridNodes, most_nodes(area_by_nodes(field.surface(), chosen.nodes)));
    chosen.is_coarse = 4.0 * side * side > most;
    if (chosen.is_coarse) return chosen;
  }
}

}  // namespace surfmesh
