// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/make_control.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/control/point_nodes.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/metric/minimum.hh"
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

/// Points of the independent sample: a share of the nodes, within bounds.
int sample_count(std::size_t nodes) {
  return static_cast<int>(std::clamp<std::size_t>(4 * nodes, 100, 100'000));
}

double root_of_determinant(const FirstFormFactor& form, const SizeTensor& size) {
  return form.l11 * form.l22 / determinant(size);
}

/// True if there is more than `at`.
bool has_other_sources(const PatchSources& sources, const SizeField& field) {
  return field.has_area_source() || !sources.along.empty() || !sources.trees.empty();
}

std::vector<ControlNode> choose_accurate_nodes(const SizeField& field, ControlNodeOptions options) {
  std::vector<ControlNode> nodes = choose_control_nodes(field, options);
  if (options.regular > 0 || !field.has_source()) return nodes;
  for (int round = 0; round < kMaxRounds; ++round) {
    const ControlSpace control(field.surface().domain(), nodes, 0);
    const MetricArea area = metric_area(field, control, sample_count(nodes.size()));
    const double error = std::abs(area.control - area.exact);
    if (error <= std::max(kNegligibleArea, kAreaError * area.exact)) break;
    options.precision *= kFinerPrecision;
    nodes = choose_control_nodes(field, options);
  }
  return nodes;
}

}  // namespace

MetricArea metric_area(const SizeField& field, const ControlSpace& control, int samples) {
  // The additive sequence of the plastic number covers the square evenly and has no period.
  // Source: Roberts, The unreasonable effectiveness of quasirandom sequences (2018).
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  const Domain domain = field.surface().domain();
  const double cell = (domain.u1 - domain.u0) * (domain.v1 - domain.v0) / samples;
  MetricArea area;
  ControlSpace::Hint hint;
  for (int i = 1; i <= samples; ++i) {
    double whole = 0;
    const Uv uv = domain.at(std::modf(i * first, &whole), std::modf(i * second, &whole));
    if (!(domain.fold(uv) == uv)) continue;
    const SizeField::Sample sample = field.at(uv);
    area.exact += cell * root_of_determinant(sample.form, sample.size);
    area.control += cell * root_of_determinant(sample.form, control.size(uv, sample.form, hint));
  }
  return area;
}

ControlSpace make_control(const Surface& surface, const Sizing& sizing, const PatchSources& sources,
                          double diagonal, const ControlNodeOptions& options) {
  ControlNodeOptions own = options;
  own.precision = sources.precision().value_or(options.precision);
  check(own);
  const SizeField field(surface, sizing, sources, diagonal, own.precision);
  const std::vector<ControlNode> points = field_nodes(sources, field, sizing.grade > 0);
  const bool is_chosen = has_other_sources(sources, field) || points.empty();
  std::vector<ControlNode> nodes =
      is_chosen ? choose_accurate_nodes(field, own) : corners_like_nearest(surface, points);
  nodes.insert(nodes.end(), points.begin(), points.end());
  return ControlSpace(surface.domain(), nodes, sizing.grade);
}

}  // namespace surfmesh
