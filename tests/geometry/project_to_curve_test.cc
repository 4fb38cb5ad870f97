// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_to_curve.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/analytic.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

const Domain kTurn{0, 2 * pi, 0, 1};

Vec3 on(const Surface& surface, const Curve& curve, double t) {
  return surface.evaluate(curve.evaluate(t), Order::Position).point;
}

/// A point of the curve is found to `tolerance` in space from guesses of every quality.
void expect_found(const Surface& surface, const Curve& curve, double tolerance) {
  for (const double t : {0.0, 1e-9, 0.1, 0.37, 0.5, 0.93, 1 - 1e-9, 1.0}) {
    const Vec3 point = on(surface, curve, t);
    for (const double guess : {t, t + 0.02, 0.0, 0.5, 1.0, -3.0}) {
      const double found = project_to_curve(surface, curve, point, guess);
      ASSERT_TRUE(found >= 0 && found <= 1) << found;
      EXPECT_LE((on(surface, curve, found) - point).norm(), tolerance) << t << " from " << guess;
    }
  }
}

TEST(ProjectToCurve, FindsPointsOnTheCurve) {
  expect_found(test::PlanePatch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), SegmentCurve({0, 0}, {1, 1}),
               1e-15);
  expect_found(test::Cylinder(1, kTurn), SegmentCurve({0, 0.5}, {2 * pi, 0.5}), 2e-15);
  expect_found(test::Torus(2, 0.5, kTurn), SegmentCurve({0, 0}, {pi, 2 * pi}), 2e-15);
  expect_found(test::Sphere(1, {}), SegmentCurve({0.3, -pi / 2}, {0.3, pi / 2}), 2e-15);
  expect_found(test::Reparametrised(std::make_shared<test::Cylinder>(1, kTurn)),
               SegmentCurve({0, 1}, {1, 1}), 2e-15);
}

TEST(ProjectToCurve, FindsPointsOnCurvesThatAreNoSegments) {
  const CallableCurve circle([](double t) {
    return Uv{0.5 + 0.3 * std::cos(2 * pi * t), 0.5 + 0.3 * std::sin(2 * pi * t)};
  });
  expect_found(test::Sphere(1, {}), circle, 1e-15);
}

TEST(ProjectToCurve, PassesPlacesWithoutSpeed) {
  const CallableCurve cubic([](double t) {
    const double s = 2 * t - 1;
    return Uv{s * s * s, 0.0};
  });
  expect_found(test::PlanePatch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), cubic, 1e-15);
}

TEST(ProjectToCurve, DoesNotDependOnTheScaleOfParameters) {
  const Domain uneven{1e6, 2e6, 0, 1e-3};
  const test::PlanePatch plane({0, 0, 0}, {1e-6, 0, 0}, {0, 1e3, 0}, uneven);
  expect_found(plane, SegmentCurve({1e6, 0}, {2e6, 0}), 1e-15);
  expect_found(plane, SegmentCurve({1e6, 0}, {1e6, 1e-3}), 1e-15);
  expect_found(plane, SegmentCurve({2e6, 0}, {1e6, 1e-3}), 1e-15);
}

TEST(ProjectToCurve, FindsPointsFarFromTheOrigin) {
  const auto cylinder = std::make_shared<test::Cylinder>(1, kTurn);
  const SegmentCurve circle({0, 0}, {2 * pi, 0});
  expect_found(test::Placed(cylinder, 1, {1e6, -1e6, 0}), circle, 1e-9);
  expect_found(test::Placed(cylinder, 1e6, {0, 0, 0}), circle, 1e-9);
  expect_found(test::Placed(cylinder, 1e-3, {0, 0, 0}), circle, 1e-18);
}

/// The angle of a point off a circle is known.
TEST(ProjectToCurve, IsNearestFromAside) {
  const test::Cylinder cylinder(1, kTurn);
  const SegmentCurve circle({0, 0}, {2 * pi, 0});
  for (const double radius : {0.1, 0.5, 0.999, 1.001, 3.0, 100.0}) {
    for (const double t : {0.001, 0.2, 0.55, 0.999}) {
      const Vec3 point(radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t), 0.3);
      EXPECT_NEAR(project_to_curve(cylinder, circle, point, 0.7), t, 1e-13) << radius;
    }
  }
}

/// The bound of the docstring, on a curve whose tangent has a truncation error.
TEST(ProjectToCurve, IsNearestFromAsideOfACurve) {
  const test::PlanePatch plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const CallableCurve sine([](double t) { return Uv{t, std::sin(t)}; });
  const double t = 0.6;
  const Vec3 normal(-std::cos(t), 1, 0);
  for (const double d : {-0.5, -1e-3, 1e-3, 0.3}) {
    const Vec3 point = on(plane, sine, t) + d * normal;
    EXPECT_NEAR(project_to_curve(plane, sine, point, 0.1), t, 1e-8 * std::abs(d)) << d;
  }
}

TEST(ProjectToCurve, EndsWhereTheCurveEnds) {
  const test::PlanePatch plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const SegmentCurve segment({0, 0}, {1, 0});
  EXPECT_EQ(project_to_curve(plane, segment, {-2, 1, 0}, 0.8), 0);
  EXPECT_EQ(project_to_curve(plane, segment, {2, 1, 0}, 0.2), 1);
}

TEST(ProjectToCurve, TakesTheEndOfAClosedCurveThatTheGuessIsNearTo) {
  const test::Cylinder cylinder(1, kTurn);
  const SegmentCurve circle({0, 0}, {2 * pi, 0});
  for (const double r : {0.9, 1.0, 1.1}) {
    EXPECT_NEAR(project_to_curve(cylinder, circle, {r, 0, 0}, 0.1), 0, 1e-13) << r;
    EXPECT_NEAR(project_to_curve(cylinder, circle, {r, 0, 0}, 0.9), 1, 1e-13) << r;
  }
}

TEST(ProjectToCurve, TakesTheEndByTheGuessFarFromTheOriginToo) {
  const test::Placed cylinder(std::make_shared<test::Cylinder>(1, kTurn), 1, {1e6, 2e6, 3e6});
  const SegmentCurve circle({0, 0}, {2 * pi, 0});
  const Vec3 start = on(cylinder, circle, 0);
  EXPECT_NEAR(project_to_curve(cylinder, circle, start, 0.2), 0, 1e-9);
  EXPECT_NEAR(project_to_curve(cylinder, circle, start, 0.8), 1, 1e-9);
}

TEST(ProjectToCurve, AnswersForACurveThatIsOnePoint) {
  const test::Sphere sphere(1, {});
  const SegmentCurve pole({0, pi / 2}, {1, pi / 2});
  EXPECT_EQ(project_to_curve(sphere, pole, {0, 0, 2}, 0.25), 0.25);
}

}  // namespace
}  // namespace surfmesh
