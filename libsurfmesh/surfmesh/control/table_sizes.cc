// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/table_sizes.hh"

#include <fmt/format.h>

#include <cmath>

#include "surfmesh/control/place_sources.hh"
#include "surfmesh/control/regular_place.hh"
#include "surfmesh/control/thin_nodes.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Share of the precision that thinning may take; the rest is for the control space that
/// represents the thinned table.
constexpr double kThinningShare = 0.5;

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
  std::vector<ControlNode> nodes;
  nodes.reserve(source.nodes.size());
  for (const TableNode& node : source.nodes) {
    const Uv uv = inside_domain(surface, node.uv);
    const Jet jet = surface.evaluate(uv, Order::First);
    const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
    const bool is_size = std::isnan(node.metric.m11);
    const SizeTensor size = is_size ? bounds.tensor(node.size)
                                    : size_from_metric_at(surface, uv, form, node.metric);
    nodes.push_back({uv, jet.point, form, bounds.clamp(size), {}});
  }
  return nodes;
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
