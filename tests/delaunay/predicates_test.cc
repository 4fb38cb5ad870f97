// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/predicates.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "surfmesh/delaunay/in_circle.hh"

namespace surfmesh {
namespace {

TEST(Orient2d, CyclicShiftKeepsAndExchangeInvertsTheSign) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Uv a{uniform(random), uniform(random)}, b{uniform(random), uniform(random)};
    const Uv c = lerp(a, b, uniform(random));  // nearly collinear
    const int sign = orient2d(a, b, c);
    EXPECT_EQ(orient2d(b, c, a), sign);
    EXPECT_EQ(orient2d(c, a, b), sign);
    EXPECT_EQ(orient2d(b, a, c), -sign);
  }
}

TEST(Orient2d, SeesOneUnitInTheLastPlace) {
  const Uv a{0.1, 0.1}, b{0.3, 0.3};
  const Uv on{0.2, 0.2}, above{0.2, std::nextafter(0.2, 1)}, below{0.2, std::nextafter(0.2, 0)};
  EXPECT_EQ(orient2d(a, b, on), 0);
  EXPECT_EQ(orient2d(a, b, above), 1);
  EXPECT_EQ(orient2d(a, b, below), -1);
}

TEST(Orient2d, IsExactForNumbersOfAnySize) {
  const double tiny = 1e-200;
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {tiny, tiny}), 0);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {tiny, std::nextafter(tiny, 1)}), 1);
  EXPECT_EQ(orient2d({0, 0}, {1e150, 1e150}, {0.1, std::nextafter(0.1, 0)}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1e150, 1e150}, {0.1, 0.1}), 0);
}

TEST(Orient2d, DoesNotDependOnTheScaleOfTheAxes) {
  const auto scaled = [](Uv p) { return Uv{p.u * 0x1p20, p.v * 0x1p-10}; };
  const Uv a{0.1, 0.7}, b{0.4, 0.2}, c{0.3, 0.9};
  EXPECT_EQ(orient2d(scaled(a), scaled(b), scaled(c)), orient2d(a, b, c));
}

TEST(InMetricCircle, IsTheCircleOfTheMetric) {
  // The unit circle of diag(1, 1/4) is the ellipse with half axes 1 and 2.
  const Metric m{1, 0, 0.25};
  const std::array<Uv, 3> triangle = {Uv{1, 0}, Uv{0, 2}, Uv{-1, 0}};
  EXPECT_TRUE(in_metric_circle(triangle, {0, -1.99}, m));
  EXPECT_FALSE(in_metric_circle(triangle, {0, -2.01}, m));
  EXPECT_FALSE(in_metric_circle(triangle, {0.9, 1.2}, m));
}

TEST(InMetricCircle, CountsCocircularPointsAsOutside) {
  const std::array<Uv, 3> triangle = {Uv{0, 0}, Uv{1, 0}, Uv{1, 1}};
  EXPECT_FALSE(in_metric_circle(triangle, {0, 1}, {1, 0, 1}));
}

TEST(Orient2d, OfAPointThatIsNotFiniteIsZero) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, Uv()), 0);
  EXPECT_EQ(orient2d({0, 0}, {INFINITY, 0}, {0, 1}), 0);
}

}  // namespace
}  // namespace surfmesh
