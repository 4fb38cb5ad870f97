// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/accurate_nodes.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/tensor.hh"

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

/// Nodes along a side of the first grid, and above which no finer one is tried: a million nodes.
constexpr int kFirstGridSide = 9;
constexpr int kLastGridSide = 1000;

/// Points of the independent sample: a share of the nodes, within bounds.
int sample_count(std::size_t nodes) {
  return static_cast<int>(std::clamp<std::size_t>(4 * nodes, 100, 100'000));
}

/// Call `visit(uv)` for points of a domain that cover it evenly: the additive sequence of the
/// plastic number, which has no period; for a triangular domain those of its rectangle that lie in
/// it.
/// Source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
template <class Visit>
void for_each_quasi_random(const Domain& domain, int samples, Visit visit) {
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  for (int i = 1; i <= samples; ++i) {
    double whole = 0;
    const Uv uv = domain.at(std::modf(i * first, &whole), std::modf(i * second, &whole));
    if (domain.fold(uv) == uv) visit(uv);
  }
}

double root_of_determinant(const FirstFormFactor& form, const SizeTensor& size) {
  return form.l11 * form.l22 / determinant(size);
}

/// True if a grid of control nodes holds the field to the precision at quasi-random points, or is
/// finer there than the elements.
bool holds(const ControlGrid& grid, const SizeField& field, int side, double precision) {
  const Domain domain = field.surface().domain();
  const Uv u_step{(domain.u1 - domain.u0) / (side - 1), 0};
  const Uv v_step{0, (domain.v1 - domain.v0) / (side - 1)};
  ControlSpace::Hint hint;
  bool is_good = true;
  for_each_quasi_random(domain, 2 * side * side, [&](Uv uv) {
    if (!is_good) return;
    const SizeField::Sample sample = field.at(uv);
    const Metric metric = metric_from_size(sample.form, sample.size);
    const double cell = std::max(squared_length(metric, u_step), squared_length(metric, v_step));
    if (cell < kLeastCellLength * kLeastCellLength) return;
    const SizeTensor size = grid.size({uv, sample.point, sample.form}, hint);
    is_good = log_conformity(sample.size, size) <= precision;
  });
  return is_good;
}

}  // namespace

MetricArea metric_area(const SizeField& field, const ControlSpace& control, int samples) {
  const Domain domain = field.surface().domain();
  const double cell = (domain.u1 - domain.u0) * (domain.v1 - domain.v0) / samples;
  MetricArea area;
  ControlSpace::Hint hint;
  for_each_quasi_random(domain, samples, [&](Uv uv) {
    const SizeField::Sample sample = field.at(uv);
    area.exact += cell * root_of_determinant(sample.form, sample.size);
    area.control += cell * root_of_determinant(sample.form, control.size({uv, sample.point, sample.form}, hint));
  });
  return area;
}

ChosenNodes choose_accurate_nodes(const SizeField& field, const ControlNodeOptions& given) {
  ControlNodeOptions options = given;
  ChosenNodes chosen = choose_control_nodes(field, options);
  if (options.regular > 0 || !field.has_source()) return chosen;
  const Interpolation interpolation =
      options.by_distance ? Interpolation::Triangle : Interpolation::Linear;
  for (int round = 0; round < kMaxRounds && !chosen.is_coarse; ++round) {
    const ControlMesh control(field.surface().domain(), chosen.nodes,
                              {.interpolation = interpolation});
    const MetricArea area = metric_area(field, control, sample_count(chosen.nodes.size()));
    const double error = std::abs(area.control - area.exact);
    if (error <= std::max(kNegligibleArea, kAreaError * area.exact)) break;
    options.precision *= kFinerPrecision;
    chosen = choose_control_nodes(field, options);
  }
  return chosen;
}

ChosenNodes choose_grid_nodes(const SizeField& field, const ControlNodeOptions& options) {
  if (options.regular > 0) return choose_control_nodes(field, options);
  for (int side = kFirstGridSide;; side = 2 * side - 1) {
    ChosenNodes chosen = choose_control_nodes(field, {.regular = side * side});
    const ControlGrid grid(field.surface().domain(), chosen.nodes, {}, {});
    if (holds(grid, field, side, options.precision)) return chosen;
    chosen.is_coarse = side > kLastGridSide;
    if (chosen.is_coarse) return chosen;
  }
}

}  // namespace surfmesh
