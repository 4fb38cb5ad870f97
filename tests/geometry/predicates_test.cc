// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/predicates.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

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

TEST(Orient2d, OfAPointThatIsNotFiniteIsZero) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, Uv()), 0);
  EXPECT_EQ(orient2d({0, 0}, {INFINITY, 0}, {0, 1}), 0);
}

/// Four points nearly in a plane.
std::array<Vec3, 4> nearly_coplanar(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  const Vec3 a = point(), b = point(), c = point();
  return {a, b, c, a + uniform(random) * (b - a) + uniform(random) * (c - a)};
}

TEST(Orient3d, EveryExchangeInvertsTheSign) {
  std::mt19937 random(1);
  int zeros = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d] = nearly_coplanar(random);
    const int sign = orient3d(a, b, c, d);
    zeros += sign == 0;
    EXPECT_EQ(orient3d(b, c, a, d), sign);
    EXPECT_EQ(orient3d(b, a, c, d), -sign);
    EXPECT_EQ(orient3d(a, b, d, c), -sign);
    EXPECT_EQ(orient3d(d, b, c, a), -sign);
  }
  EXPECT_LT(zeros, 100);
}

TEST(Orient3d, IsPositiveOnTheSideFromWhichTheTriangleRunsCounterClockwise) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
}

TEST(Orient3d, SeesOneUnitInTheLastPlace) {
  // The plane x = z, where every sum of the determinant is rounded.
  const Vec3 a(0.1, 0.3, 0.1), b(0.7, 0.2, 0.7), c(0.9, 0.9, 0.9);
  const double x = 0.4, up = std::nextafter(x, 1), down = std::nextafter(x, 0);
  EXPECT_EQ(orient3d(a, b, c, {x, 0.7, x}), 0);
  const int side = orient3d(a, b, c, {x, 0.7, 1});
  EXPECT_NE(side, 0);
  EXPECT_EQ(orient3d(a, b, c, {x, 0.7, up}), side);
  EXPECT_EQ(orient3d(a, b, c, {x, 0.7, down}), -side);
}

TEST(Orient3d, IsZeroForAVertexAndForPointsThatAreNotFinite) {
  const Vec3 a(0.1, 0.3, 0.2), b(0.7, 0.2, 0.5), c(0.9, 0.9, 0.4);
  for (const Vec3& d : {a, b, c, Vec3(NAN, 0, 0), Vec3(0, INFINITY, 0)}) {
    EXPECT_EQ(orient3d(a, b, c, d), 0);
  }
}

}  // namespace
}  // namespace surfmesh
