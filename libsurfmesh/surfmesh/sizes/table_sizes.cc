// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/table_sizes.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/beside_pole.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sizes/place_sources.hh"
#include "surfmesh/sizes/thin_nodes.hh"

namespace surfmesh {
namespace {

/// Share of the precision that thinning may take; the rest is for the control space that
/// represents the thinned table.
constexpr double kThinningShare = 0.5;

/// Share of the greatest speed of the parameters among the rows below which one stands still: at a
/// pole it is zero but for rounding, from where sizes would come out as nothing.
constexpr double kPoleSpeed = 1e-9;

/// Logarithm of the ratio of two lengths that differ by rounding: sizes that come from a mesh have
/// been metrics in between.
constexpr double kTableRounding = 1e-9;

/// Speed of a parameter: |p_u| and |p_v|.
double speed_of_u(const FirstFormFactor& form) { return form.l11; }
double speed_of_v(const FirstFormFactor& form) { return std::hypot(form.l21, form.l22); }

/// Leave out the nodes that are given by a metric at a pole, unless there are no others: the metric
/// of a mesh there is that of points around, and belongs to their first forms.
void leave_out_poles(std::vector<ControlNode>& nodes, const std::vector<TableNode>& rows) {
  double most_u = 0, most_v = 0;
  for (const ControlNode& node : nodes) {
    most_u = std::max(most_u, speed_of_u(node.form));
    most_v = std::max(most_v, speed_of_v(node.form));
  }
  std::vector<ControlNode> others;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const FirstFormFactor& form = nodes[i].form;
    const bool is_pole = !is_regular(form) || speed_of_u(form) < kPoleSpeed * most_u ||
                         speed_of_v(form) < kPoleSpeed * most_v;
    if (!is_pole || std::isnan(rows[i].metric.m11)) others.push_back(nodes[i]);
  }
  if (!others.empty()) nodes = std::move(others);
}

/// The nodes of a table with their sizes as they are wanted.
std::vector<ControlNode> unbounded_nodes(const TableSource& source, const Surface& surface,
                                         const SizeBounds& bounds) {
  std::vector<ControlNode> nodes;
  nodes.reserve(source.nodes.size());
  for (const TableNode& node : source.nodes) {
    const Uv uv = inside_domain(surface, node.uv);
    const Jet jet = surface.evaluate(uv, Order::First);
    const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
    const bool is_size = std::isnan(node.metric.m11);
    const SizeTensor size =
        is_size ? bounds.tensor(node.size) : size_from_metric_at(surface, uv, form, node.metric);
    nodes.push_back({uv, jet.point, form, size, {}});
  }
  leave_out_poles(nodes, source.nodes);
  return nodes;
}

}  // namespace

SizeTensor size_from_metric_at(const Surface& surface, Uv uv, const FirstFormFactor& form,
                               const Metric& m) {
  const bool is_positive = m.m11 > 0 && m.m22 > 0 && determinant(m) > 0 && std::isfinite(m.m11) &&
                           std::isfinite(m.m22) && std::isfinite(determinant(m));
  if (!is_positive) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the metric [{}, {}, {}] wanted at (u,v) = ({}, {}) is not positive "
                            "definite",
                            m.m11, m.m12, m.m22, uv.u, uv.v));
  }
  if (is_regular(form)) return size_from_metric(form, m);
  const Jet jet = surface.evaluate(beside_pole(surface, uv), Order::First);
  return size_from_metric(first_form_factor(jet.du, jet.dv), m);
}

std::vector<ControlNode> table_nodes(const TableSource& source, const Surface& surface,
                                     const SizeBounds& bounds) {
  std::vector<ControlNode> nodes = unbounded_nodes(source, surface, bounds);
  for (ControlNode& node : nodes) node.size = bounds.clamp(node.size);
  return nodes;
}

std::size_t count_clamped(const TableSource& source, const Surface& surface,
                          const SizeBounds& bounds) {
  const std::vector<ControlNode> nodes = unbounded_nodes(source, surface, bounds);
  const auto count = std::count_if(nodes.begin(), nodes.end(), [&](const ControlNode& node) {
    return log_conformity(node.size, bounds.clamp(node.size)) > kTableRounding;
  });
  return static_cast<std::size_t>(count);
}

NodeInterpolation interpolate_table(const TableSource& source, const Surface& surface,
                                    const SizeBounds& bounds, double precision) {
  if (source.nodes.empty()) {
    throw Error(ErrorCode::InvalidInput, "a table of sizes has no rows");
  }
  const auto nodes = table_nodes(source, surface, bounds);
  return NodeInterpolation(
      surface, thin_nodes(surface, nodes, kThinningShare * source.precision.value_or(precision)));
}

}  // namespace surfmesh
