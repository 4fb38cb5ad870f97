// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_curve.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hh"
#include "support/nurbs_nets.hh"

namespace surfmesh {
namespace {

/// The unit circle in four arcs.
NurbsPolygon circle() {
  const double h = std::numbers::sqrt2 / 2;
  return {2,
          {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
          {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
          {1, h, 1, h, 1, h, 1, h, 1}};
}

TEST(NurbsCurve, IsTheCircle) {
  const NurbsCurve curve(circle());
  for (double t = 0; t <= 1; t += 0.03125) {
    const Uv uv = curve.evaluate(t);
    EXPECT_NEAR(std::hypot(uv.u, uv.v), 1, 1e-15);
  }
  EXPECT_EQ(curve.evaluate(0), (Uv{1, 0}));
  EXPECT_EQ(curve.evaluate(1), (Uv{1, 0}));
}

TEST(NurbsCurve, HasItsKnotsAsBreaks) {
  EXPECT_EQ(NurbsCurve(circle()).breaks(), (std::vector<double>{0.25, 0.5, 0.75}));
  EXPECT_EQ(NurbsCurve(circle(), {1, 3}).breaks(), (std::vector<double>{0.5}));
}

TEST(NurbsCurve, AgreesWithDeBoor) {
  const NurbsPolygon polygon{3,
                             testing::clamped_knots(3, 4, 1.7),
                             {{0.1, 0.3}, {1, 0.1}, {2, 3}, {2, 2}, {4, 1}, {5, 0}, {5.5, 0.7}},
                             {1, 2, 0.5, 1, 3, 1, 1}};
  const NurbsCurve curve(polygon);
  for (const double t : {0.0, 0.01, 0.3, 0.5, 0.77, 1.0}) {
    long double u = 0, v = 0, w = 0;
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const long double factor = polygon.weights[i] * testing::basis(polygon.knots, i, 3, t, 0);
      u += factor * polygon.points[i].u, v += factor * polygon.points[i].v, w += factor;
    }
    EXPECT_NEAR(curve.evaluate(t).u, static_cast<double>(u / w), 1e-14);
    EXPECT_NEAR(curve.evaluate(t).v, static_cast<double>(v / w), 1e-14);
  }
}

TEST(NurbsCurve, NeverLeavesTheLineOfItsPoints) {
  const NurbsCurve curve(NurbsPolygon{
      2, {0, 0, 0, 1, 1, 1}, {{0.1, 1.0 / 3}, {0.7, 1.0 / 3}, {0.9, 1.0 / 3}}, {1, 0.3, 2}});
  for (double t = 0; t <= 1; t += 0.0625) EXPECT_EQ(curve.evaluate(t).v, 1.0 / 3);
}

TEST(NurbsCurve, IsAPartBetweenTwoParameters) {
  const NurbsCurve whole(circle()), part(circle(), {0.5, 1.5});
  EXPECT_NEAR(part.evaluate(0).u, whole.evaluate(0.125).u, 1e-15);
  EXPECT_NEAR(part.evaluate(0.5).v, 1, 1e-15);
}

TEST(NurbsCurve, ClosesWhereItIsPeriodic) {
  const NurbsPolygon polygon{3, {0, 1, 2, 3, 4}, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {}, true};
  const NurbsCurve curve(polygon), moved(polygon, {2.5, 6.5});
  EXPECT_NEAR(curve.evaluate(0).u, curve.evaluate(1).u, 1e-15);
  EXPECT_NEAR(curve.evaluate(0).v, curve.evaluate(1).v, 1e-15);
  EXPECT_NEAR(moved.evaluate(0.5).u, curve.evaluate(0.125).u, 1e-15);
  EXPECT_EQ(curve.breaks().size(), 3u);
}

TEST(NurbsCurve, RefusesRangesBeyondItsKnots) {
  EXPECT_EQ(
      error_of([] {
        NurbsCurve(circle(), {0, 5});
      }),
      "invalid input: the range from 0 to 5 is not one of the knots, which reach from 0 to 4");
  EXPECT_NE(error_of([] { NurbsCurve(circle(), {2, 1}); }), "no error");
}

}  // namespace
}  // namespace surfmesh
