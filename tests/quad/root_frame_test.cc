// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/root_frame.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/metric_fields.hh"
#include "support/tensors.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

/// The derivative of the root of a field along a step, by central differences.
RootFrame root_along(const testing::FunctionField& field, Uv at, Uv step) {
  constexpr double t = 1e-4;
  const RootFrame after(field(at + t * step)), before(field(at - t * step));
  RootFrame result;
  result.s11 = (after.s11 - before.s11) / (2 * t);
  result.s12 = (after.s12 - before.s12) / (2 * t);
  result.s22 = (after.s22 - before.s22) / (2 * t);
  return result;
}

Connection connection_at(const testing::FunctionField& field, Uv at) {
  const RootFrame frame(field(at));
  return connection_from(frame, root_along(field, at, frame.step({1, 0})),
                         root_along(field, at, frame.step({0, 1})));
}

/// The angle by which a vector that is carried along a circle turns against the root frame.
double turn_around(const testing::FunctionField& field, Uv centre, double radius) {
  constexpr int count = 2000;
  double angle = 0;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count;
    const Uv at = centre + radius * Uv{std::cos(t), std::sin(t)};
    const Uv step = 2 * pi / count * radius * Uv{-std::sin(t), std::cos(t)};
    angle += connection_at(field, at).angle(step);
  }
  return angle;
}

TEST(Direction, TurnsByAnAngleAndStaysAUnitVector) {
  const Direction d{std::cos(0.4), std::sin(0.4)};
  for (const double angle : {-2.0, -0.1, 0.0, 0.05, 0.2, 3.0}) {
    const Direction t = d.turned(angle);
    EXPECT_NEAR(t.c * t.c + t.s * t.s, 1, 1e-15);
    const double error = std::abs(std::atan2(d.c * t.s - d.s * t.c, d.c * t.c + d.s * t.s) - angle);
    EXPECT_LE(error, std::abs(angle * angle * angle) / 12 + 1e-15);
  }
}

TEST(Direction, IsTheSameAfterFourQuarterTurns) {
  const Direction d{0.6, 0.8};
  const Direction quarter = d.quarter_turn();
  EXPECT_EQ(d.c * quarter.c + d.s * quarter.s, 0);
  EXPECT_GT(d.c * quarter.s - d.s * quarter.c, 0);  // counter-clockwise
  const Direction whole = quarter.quarter_turn().quarter_turn().quarter_turn();
  EXPECT_EQ(whole.c, d.c);
  EXPECT_EQ(whole.s, d.s);
}

TEST(RootFrame, IsTheSquareRootOfTheMetric) {
  for (const SizeTensor& h : testing::random_sizes(200, 1000)) {
    const Metric m = testing::metric_of(h);
    const RootFrame s(m);
    testing::expect_near(Metric{s.s11 * s.s11 + s.s12 * s.s12, s.s11 * s.s12 + s.s12 * s.s22,
                                s.s12 * s.s12 + s.s22 * s.s22},
                         m, 1e-12);
    EXPECT_GT(s.s11, 0);
    EXPECT_GT(s.determinant_of_root(), 0);
  }
}

TEST(RootFrame, StepsByMetricLengthOne) {
  for (const SizeTensor& h : testing::random_sizes(100, 100)) {
    const Metric m = testing::metric_of(h);
    const RootFrame s(m);
    for (const Uv d : testing::directions(7)) {
      const Uv step = s.step({d.u, d.v});
      EXPECT_NEAR(squared_length(m, step), 1, 1e-10);
      const Uv back = s.in_frame(step);
      EXPECT_NEAR(back.u, d.u, 1e-10);
      EXPECT_NEAR(back.v, d.v, 1e-10);
    }
  }
}

TEST(RootFrame, TellsHowFarAStepGoesAlongADirectionAndToItsLeft) {
  const RootFrame s(testing::metric_of(size_tensor(0.5, 0.02, 0.3)));
  const Direction ahead{0.6, 0.8};
  const Uv along = s.along(ahead, s.step(ahead)),
           left = s.along(ahead, s.step(ahead.quarter_turn()));
  EXPECT_NEAR(along.u, 1, 1e-14);
  EXPECT_NEAR(along.v, 0, 1e-14);
  EXPECT_NEAR(left.u, 0, 1e-14);
  EXPECT_NEAR(left.v, 1, 1e-14);
}

TEST(Connection, OfAConstantMetricIsZero) {
  const Metric m = testing::metric_of(size_tensor(0.5, 0.02, 0.3));
  const Connection connection = connection_at(testing::constant_field(m), {0.3, 0.7});
  EXPECT_EQ(connection.form.u, 0);
  EXPECT_EQ(connection.form.v, 0);
}

TEST(Connection, OfAnIsotropicSizeIsTheGradientOfItsLogarithmTurnedByARightAngle) {
  const auto size = [](Uv p) { return 0.1 + 0.05 * std::sin(3 * p.u) + 0.02 * p.u * p.v; };
  const auto field = testing::isotropic_field(size);
  for (const Uv at : {Uv{0.2, 0.1}, Uv{0.9, 0.3}, Uv{0.5, 0.8}}) {
    const Connection connection = connection_at(field, at);
    constexpr double t = 1e-5;
    const double by_u = std::log(size(at + Uv{t, 0}) / size(at - Uv{t, 0})) / (2 * t);
    const double by_v = std::log(size(at + Uv{0, t}) / size(at - Uv{0, t})) / (2 * t);
    EXPECT_NEAR(connection.form.u, -by_v, 1e-5);
    EXPECT_NEAR(connection.form.v, by_u, 1e-5);
  }
}

/// The unit sphere in longitude and latitude.
testing::FunctionField sphere_field() {
  return testing::FunctionField([](Uv p) { return Metric{std::pow(std::cos(p.v), 2), 0, 1}; });
}

/// dω = −K dA: what a vector that is carried around a loop turns by is the curvature inside.
TEST(Connection, TurnsAVectorAroundALoopByTheCurvatureInside) {
  constexpr double radius = 0.3, latitude = 0.6;
  // ∫ cos v over the disc, by the mean of cos on each vertical chord.
  double area = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double u = radius * (2 * (i + 0.5) / count - 1), v = std::sqrt(radius * radius - u * u);
    area += 2 * radius / count * (std::sin(latitude + v) - std::sin(latitude - v));
  }
  const double turn = turn_around(sphere_field(), {0, latitude}, radius);
  EXPECT_NEAR(std::abs(turn), area, 1e-4);
}

TEST(Connection, TurnsAVectorTheOtherWayWhereTheCurvatureIsNegative) {
  const auto saddle = testing::FunctionField([](Uv p) {
    return Metric{std::pow(std::cosh(p.v), 2), 0, 1};
  });
  EXPECT_LT(turn_around(saddle, {0, 0.6}, 0.3) * turn_around(sphere_field(), {0, 0.6}, 0.3), 0);
}

/// A flat metric in other parameters, u' = u + v³: no curvature, though the metric changes.
TEST(Connection, TurnsNothingAroundALoopInAFlatMetric) {
  const auto flat = testing::FunctionField([](Uv p) {
    const double slope = 3 * p.v * p.v;
    return Metric{1, slope, 1 + slope * slope};
  });
  EXPECT_GT(std::abs(connection_at(flat, {0, 0.6}).form.v), 0.1);
  EXPECT_NEAR(turn_around(flat, {0, 0.6}, 0.3), 0, 1e-5);
}

}  // namespace
}  // namespace surfmesh
