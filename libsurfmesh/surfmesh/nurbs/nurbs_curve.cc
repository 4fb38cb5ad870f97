// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_curve.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "surfmesh/core/error.hh"
#include "surfmesh/nurbs/full_knots.hh"

namespace surfmesh {
namespace {

FullKnots knots_of(const NurbsPolygon& polygon) {
  check(polygon);
  return full_knots(polygon.knots, polygon.degree, polygon.periodic);
}

CurveRange whole_range(const NurbsPolygon& polygon) {
  const FullKnots knots = knots_of(polygon);
  return {knots.from(), knots.to()};
}

void check_range(const FullKnots& knots, const CurveRange& range) {
  const double rounding = knots.rounding();
  const bool is_within =
      knots.period > 0 ? range.to - range.from <= knots.period + rounding
                       : range.from >= knots.from() - rounding && range.to <= knots.to() + rounding;
  if (is_within && range.to - range.from > 2 * rounding) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the range from {} to {} is not one of the knots, which reach from {} to "
                          "{}",
                          range.from, range.to, knots.from(), knots.to()));
}

/// The middle between the least and the greatest value; exactly the value if all are equal.
template <class Value>
double middle_of(const std::vector<Uv>& points, Value value) {
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(), [&](const Uv& a, const Uv& b) { return value(a) < value(b); });
  return (value(*least) + value(*most)) / 2;
}

}  // namespace

NurbsCurve::NurbsCurve(const NurbsPolygon& polygon) : NurbsCurve(polygon, whole_range(polygon)) {}

NurbsCurve::NurbsCurve(const NurbsPolygon& polygon, const CurveRange& range)
    : range_(range), degree_(polygon.degree) {
  const FullKnots knots = knots_of(polygon);
  check_range(knots, range);
  spans_ = KnotSpans(knots, range.from, range.to);
  centre_ = {middle_of(polygon.points, [](Uv p) { return p.u; }),
             middle_of(polygon.points, [](Uv p) { return p.v; })};
  const int size = degree_ + 1;
  factors_.assign(static_cast<std::size_t>(spans_.count() * size), Eigen::Vector3d::Zero());
  for (int span = 0; span < spans_.count(); ++span) {
    const std::vector<double> functions = span_functions(knots, spans_.knot(span));
    for (int i = 0; i < size * size; ++i) {
      const auto point =
          static_cast<std::size_t>(spans_.knot(span) - degree_ + i / size) % polygon.points.size();
      const Uv uv = polygon.points[point] - centre_;
      const double weight = polygon.weights.empty() ? 1 : polygon.weights[point];
      factors_[static_cast<std::size_t>(span * size + i % size)] +=
          functions[static_cast<std::size_t>(i)] * weight * Eigen::Vector3d(uv.u, uv.v, 1);
    }
  }
  const std::vector<double>& lines = spans_.lines();
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
    breaks_.push_back((lines[i] - range.from) / (range.to - range.from));
  }
  const auto is_clamped = [&](double knot) { return knots.multiplicity(knot) > degree_; };
  if (range.from == knots.from() && is_clamped(knots.from())) start_ = polygon.points.front();
  if (range.to == knots.to() && is_clamped(knots.to())) end_ = polygon.points.back();
}

Uv NurbsCurve::evaluate_at(double parameter) const {
  const KnotSpans::Place place = spans_.place(parameter);
  const Eigen::Vector3d* factors = factors_.data() + place.span * (degree_ + 1);
  Eigen::Vector3d sum = factors[degree_];
  for (int k = degree_ - 1; k >= 0; --k) sum = sum * place.s + factors[k];
  return {centre_.u + sum[0] / sum[2], centre_.v + sum[1] / sum[2]};
}

Uv NurbsCurve::evaluate(double t) const {
  if (t == 0 && start_) return *start_;
  if (t == 1 && end_) return *end_;
  return evaluate_at(range_.at(t));
}

}  // namespace surfmesh
