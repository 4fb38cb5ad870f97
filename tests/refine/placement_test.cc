// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/placement.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::constant_field;
using testing::FunctionField;
using testing::metric_of;
using testing::random_sizes;

/// The image under H of a triangle of the plane: its metric is the plane's lengths.
BaseTriangle triangle_in(const SizeTensor& h, Uv a, Uv b, Uv apex) {
  const auto image = [&](Uv p) {
    return MetricCorner{{h.h11 * p.u + h.h12 * p.v, h.h12 * p.u + h.h22 * p.v}, metric_of(h)};
  };
  return {image(a), image(b), image(apex)};
}

double length(const MetricCorner& a, Uv p) { return std::sqrt(squared_length(a.metric, p - a.uv)); }

Uv frontal(const BaseTriangle& t, const FunctionField& field) {
  const std::optional<Uv> place = frontal_point(t);
  return place ? correct_frontal_point(t, {*place, field(*place)}) : circumcentre(t);
}

TEST(Circumcentre, IsEquallyFarFromAllCorners) {
  for (const SizeTensor& h : random_sizes(100, 1000)) {
    const BaseTriangle t = triangle_in(h, {0, 0}, {1.2, 0.1}, {0.4, 2});
    const Uv p = circumcentre(t);
    EXPECT_NEAR(length(t.b, p), length(t.a, p), 1e-9);
    EXPECT_NEAR(length(t.apex, p), length(t.a, p), 1e-9);
  }
}

TEST(Circumcentre, OfAnObtuseTriangleLiesBehindTheBase) {
  const Metric m{1, 0, 1};
  const Uv p = circumcentre({{{0, 0}, m}, {{2, 0}, m}, {{1, 0.5}, m}});
  EXPECT_NEAR(p.u, 1, 1e-15);
  EXPECT_NEAR(p.v, -0.75, 1e-15);
}

TEST(FrontalPoint, OverAUnitBaseIsTheEquilateralApexOfAnyMetric) {
  for (const SizeTensor& h : random_sizes(100, 1000)) {
    const BaseTriangle t = triangle_in(h, {0, 0}, {1, 0}, {0.4, 5});
    const Uv p = frontal(t, constant_field(metric_of(h)));
    EXPECT_NEAR(length(t.a, p), 1, 1e-9);
    EXPECT_NEAR(length(t.b, p), 1, 1e-9);
    EXPECT_GT(cross(t.b.uv - t.a.uv, p - t.a.uv), 0);
  }
}

TEST(FrontalPoint, MakesUnitLegsOverAnyBase) {
  const Metric m{1, 0, 1};
  for (const double base : {0.6, 0.8, 1.2, 1.4}) {
    const BaseTriangle t{{{0, 0}, m}, {{base, 0}, m}, {{0.5 * base, 9}, m}};
    const Uv p = frontal(t, constant_field(m));
    EXPECT_NEAR(length(t.a, p), 1, 1e-12);
    EXPECT_NEAR(length(t.b, p), 1, 1e-12);
  }
}

/// How far the legs over a unit base are from 1 where sizes grow by `growth` per unit of length.
double leg_error(double growth) {
  const auto field = testing::isotropic_field([growth](Uv p) { return 1 + growth * p.v; });
  const auto at = [&](Uv p) { return MetricCorner{p, field(p)}; };
  const BaseTriangle t{at({0, 0}), at({1, 0}), at({0.5, 9})};
  const MetricCorner p = at(frontal(t, field));
  return std::max(std::abs(fast_edge_length(t.a.uv, t.a.metric, p.uv, p.metric) - 1),
                  std::abs(fast_edge_length(t.b.uv, t.b.metric, p.uv, p.metric) - 1));
}

TEST(FrontalPoint, MakesNearlyUnitLegsWhereSizesGrow) { EXPECT_LT(leg_error(0.3), 0.02); }

TEST(FrontalPoint, IsCorrectedByANewtonStep) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    const BaseTriangle t = triangle_in(h, {0, 0}, {1, 0}, {0.7, 0.6});
    const MetricCorner& point = t.apex;
    const Uv step = correct_frontal_point(t, point) - point.uv;
    // To first order, a leg grows by the part of the step along it.
    for (const MetricCorner& end : {t.a, t.b}) {
      const double leg = length(end, point.uv);
      EXPECT_NEAR(inner_product(end.metric, point.uv - end.uv, step) / leg, 1 - leg, 1e-9);
    }
  }
}

TEST(FrontalPoint, ErrsInProportionToTheSquareOfTheGrowth) {
  EXPECT_LT(leg_error(0.2), 0.3 * leg_error(0.4));
  EXPECT_LT(leg_error(0.1), 0.3 * leg_error(0.2));
  EXPECT_LT(leg_error(-0.1), 0.3 * leg_error(-0.2));
}

TEST(FrontalPoint, IsTheCircumcentreWhereThatIsNearer) {
  const Metric m{1, 0, 1};
  const BaseTriangle t{{{0, 0}, m}, {{1, 0}, m}, {{0.4, 1}, m}};
  EXPECT_EQ(frontal(t, constant_field(m)), circumcentre(t));
}

TEST(FrontalPoint, IsTheCircumcentreOverABaseOfTwoAndMore) {
  const Metric m{1, 0, 1};
  const BaseTriangle t{{{0, 0}, m}, {{2.5, 0}, m}, {{1, 3}, m}};
  EXPECT_EQ(frontal(t, constant_field(m)), circumcentre(t));
}

TEST(FrontalPoint, DoesNotDependOnTheScaleOfTheParameters) {
  const FunctionField field = testing::four_point_field(0.1);
  const auto scaled = testing::with_scaled_parameters(field, 1048576, 1.0 / 1024);
  const auto at = [](const FunctionField& f, double u, double v) {
    return MetricCorner{{u, v}, f({u, v})};
  };
  const Uv p = frontal({at(field, 0.3, 0.3), at(field, 0.5, 0.35), at(field, 0.4, 2)}, field);
  const Uv q =
      frontal({at(scaled, 0.3 * 1048576, 0.3 / 1024), at(scaled, 0.5 * 1048576, 0.35 / 1024),
               at(scaled, 0.4 * 1048576, 2.0 / 1024)},
              scaled);
  EXPECT_NEAR(q.u / 1048576, p.u, 1e-12);
  EXPECT_NEAR(q.v * 1024, p.v, 1e-12);
}

TEST(FrontalPoint, IsNoneWhereTheCircumcentreIsNearer) {
  const Metric m{1, 0, 1};
  EXPECT_TRUE(frontal_point({{{0, 0}, m}, {{1, 0}, m}, {{0.4, 5}, m}}).has_value());
  EXPECT_FALSE(frontal_point({{{0, 0}, m}, {{1, 0}, m}, {{0.4, 1}, m}}).has_value());
}

TEST(FrontalPoint, MovesAtMostHalfAUnitWhereTheMetricJumps) {
  const Metric m{1, 0, 1};
  const BaseTriangle t{{{0, 0}, m}, {{1, 0}, m}, {{0.4, 5}, m}};
  const Uv p = frontal(t, constant_field(testing::isotropic_metric(100)));
  const Uv first{0.5, 0.5 * std::numbers::sqrt3};
  EXPECT_LE(std::sqrt(squared_length(testing::isotropic_metric(100), p - first)), 0.5 + 1e-12);
}

/// Triangles without area, or without a metric.
std::vector<BaseTriangle> degenerate_triangles() {
  const Metric m{1, 0, 1}, singular{1, 1, 1}, unset;
  std::vector<BaseTriangle> result;
  for (const Metric& metric : {m, singular, unset}) {
    const auto at = [&](double u, double v) { return MetricCorner{{u, v}, metric}; };
    result.push_back({at(0, 0), at(1, 0), at(2, 0)});
    result.push_back({at(0, 0), at(0, 0), at(1, 1)});
    result.push_back({at(0, 0), at(1, 0), at(1, 0)});
    result.push_back({at(1, 1), at(1, 1), at(1, 1)});
    result.push_back({at(0, 0), at(1, 0), at(0.5, -1)});
  }
  return result;
}

TEST(Placement, OfDegenerateTrianglesReturns) {
  for (const BaseTriangle& t : degenerate_triangles()) {
    circumcentre(t);
    frontal(t, constant_field(t.a.metric));
  }
}

TEST(Placement, OfATriangleWithoutAreaHasNoCircumcentre) {
  const Metric m{1, 0, 1};
  const Uv p = circumcentre({{{0, 0}, m}, {{1, 0}, m}, {{3, 0}, m}});
  EXPECT_FALSE(std::isfinite(p.u) && std::isfinite(p.v));
}

}  // namespace
}  // namespace surfmesh
