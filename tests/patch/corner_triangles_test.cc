// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/corner_triangles.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace surfmesh::detail {
namespace {

/// A corner in the plane z = 0, with x and y as parameters.
PatchCorner at(double x, double y) { return {{x, y}, Vec3(x, y, 0), Vec3(0, 0, 2)}; }

const CornerTriangle kEquilateral = {at(0, 0), at(1, 0), at(0.5, std::sqrt(0.75))};

TEST(ShapeOf, IsOneForAnEquilateralTriangle) { EXPECT_NEAR(shape_of(kEquilateral), 1, 1e-15); }

TEST(ShapeOf, IsNegativeWhereATriangleIsTurned) {
  const auto& [a, b, c] = kEquilateral;
  EXPECT_NEAR(shape_of(CornerTriangle{b, a, c}), -1, 1e-15);
}

/// A corner with a metric that asks for sizes ten times as long along y.
PatchCorner stretched_at(double x, double y) {
  PatchCorner corner = at(x, y);
  corner.metric = {1, 0, 0.01};
  return corner;
}

TEST(ShapeOf, IsOneForATriangleThatIsStretchedAsItsMetricIs) {
  const PatchCorner a = stretched_at(0, 0), b = stretched_at(1, 0);
  const double height = 10 * std::sqrt(0.75);
  EXPECT_NEAR(shape_of(CornerTriangle{a, b, stretched_at(0.5, height)}), 1, 1e-15);
  EXPECT_NEAR(shape_of(CornerTriangle{a, b, at(0.5, height)}), 1, 1e-15);  // no vertex yet
  EXPECT_LT(shape_of(CornerTriangle{at(0, 0), at(1, 0), at(0.5, height)}), 0.2);
}

TEST(ShapeOf, IsThatInSpaceWhereThatIsBetter) {
  const CornerTriangle equilateral = {stretched_at(0, 0), stretched_at(1, 0),
                                      stretched_at(0.5, std::sqrt(0.75))};
  EXPECT_NEAR(shape_of(equilateral), 1, 1e-15);
  EXPECT_NEAR(shape_of(CornerTriangle{equilateral[1], equilateral[0], equilateral[2]}), -1, 1e-15);
}

TEST(ShapeOf, IsNothingForATriangleWithoutArea) {
  EXPECT_EQ(shape_of(CornerTriangle{at(0, 0), at(1, 0), at(2, 0)}), 0);
  EXPECT_EQ(shape_of(CornerTriangle{at(1, 1), at(1, 1), at(1, 1)}), 0);
}

TEST(ShapeOf, IsThatOfTheWorstOfSeveral) {
  const CornerTriangle flat = {at(0, 0), at(1, 0), at(0.5, 0.1)};
  EXPECT_EQ(shape_of(CornerTriangles{kEquilateral, flat}), shape_of(flat));
}

double area(const CornerTriangles& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += 0.5 * cross(b.uv - a.uv, c.uv - a.uv);
  return sum;
}

TEST(Diamond, IsCoveredByItsTrianglesHoweverDivided) {
  const Diamond diamond{at(0, 0), at(1, -1), at(2, 0), at(1, 1.5)};
  EXPECT_DOUBLE_EQ(area(diamond.triangles()), 2.5);
  EXPECT_DOUBLE_EQ(area(diamond.swapped()), 2.5);
  EXPECT_DOUBLE_EQ(area(diamond.split_at(at(1, 0))), 2.5);
  EXPECT_GT(shape_of(diamond.swapped()), 0);
  EXPECT_GT(shape_of(diamond.split_at(at(1, 0))), 0);
}

}  // namespace
}  // namespace surfmesh::detail
