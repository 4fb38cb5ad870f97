// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/vertex_chart.hh"

#include <Eigen/LU>
#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Share of the lengths of the axes below which the area between them is rounding.
constexpr double kParallelAxes = 1e-9;

/// Calls that evaluate a surface; nothing where it, or the metric, cannot be evaluated.
template <class Evaluate>
std::optional<VertexChart> unless_singular(Evaluate evaluate) {
  try {
    return evaluate();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Geometry) throw;
  }
  return {};
}

}  // namespace

ChartMaker::ChartMaker(const Model& model, const std::vector<const MetricField*>& fields,
                       const SurfaceWalk& walk, const std::vector<char>& is_turned)
    : model_(model),
      fields_(fields),
      walk_(walk),
      is_turned_(is_turned),
      meets_itself_(model.patches.size(), 0),
      hints_(fields.size()) {
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 2 || contour.uses[0].patch != contour.uses[1].patch) continue;
    meets_itself_[static_cast<std::size_t>(contour.uses[0].patch)] = 1;
  }
}

std::optional<VertexChart> ChartMaker::make(const SurfacePlace& place, const Jet& jet,
                                            const Metric& metric) const {
  VertexChart chart;
  chart.place = place;
  chart.meets_itself = meets_itself(place.patch);
  chart.metric = metric;
  chart.point = jet.point;
  // The columns of L⁻ᵀ with M = L Lᵀ, of which the first is along u.
  const double l11 = std::sqrt(metric.m11), l21 = metric.m12 / l11;
  const double l22 = std::sqrt(metric.m22 - l21 * l21);
  const double sign = is_turned_[static_cast<std::size_t>(place.patch)] != 0 ? -1 : 1;
  chart.area_of_parameters = sign * l11 * l22;
  chart.u_axis = {1 / l11, 0};
  chart.v_axis = sign * Uv{-l21 / (l11 * l22), 1 / l22};
  chart.x = chart.u_axis.u * jet.du;
  chart.y = chart.v_axis.u * jet.du + chart.v_axis.v * jet.dv;
  const Vec3 across = chart.x.cross(chart.y);
  const double area = across.norm();
  if (!std::isfinite(area) || !(area > kParallelAxes * chart.x.norm() * chart.y.norm())) return {};
  const Vec3 normal = across / area;
  // The dual vectors of the axes, and the normal in units of the mean size √area.
  chart.from_space.row(0) = chart.y.cross(normal) / area;
  chart.from_space.row(1) = normal.cross(chart.x) / area;
  chart.from_space.row(2) = normal / std::sqrt(area);
  const Eigen::Matrix3d m = chart.from_space.transpose() * chart.from_space;
  chart.tensor = {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
  chart.normal = normal;
  chart.density = 1 / area;
  return chart;
}

std::optional<VertexChart> ChartMaker::make(const SurfacePlace& place) {
  return unless_singular([&] {
    const auto p = static_cast<std::size_t>(place.patch);
    const Jet jet = model_.surface(place.patch).evaluate(place.uv, Order::First);
    return make(place, jet, fields_[p]->at_jet(place.uv, jet, hints_[p]));
  });
}

std::optional<VertexChart> ChartMaker::make(const SurfacePlace& place, const Metric& metric) const {
  return unless_singular([&] {
    return make(place, model_.surface(place.patch).evaluate(place.uv, Order::First), metric);
  });
}

std::optional<VertexChart> ChartMaker::move(const VertexChart& from, ChartStep step) {
  const auto end = walk_.go(from.place, from.in_parameters(step));
  if (!end) return {};
  return make(end->place);
}

QueryCounts ChartMaker::queries() const {
  QueryCounts counts;
  for (const QueryHint& hint : hints_) counts += hint.answers;
  return counts;
}

}  // namespace surfmesh
