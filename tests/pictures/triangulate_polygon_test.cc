// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/triangulate_polygon.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace surfmesh {
namespace {

/// Signed areas in the plane, all of one sign where triangles do not overlap.
std::vector<double> areas(const std::vector<Vec3>& corners) {
  std::vector<double> result;
  for (const auto& [a, b, c] : triangulate_polygon(corners)) {
    const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
    result.push_back(0.5 * (at(b) - at(a)).cross(at(c) - at(a)).z());
  }
  return result;
}

TEST(TriangulatePolygon, CutsAQuadAtItsShorterDiagonal) {
  const auto triangles = triangulate_polygon({{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {1, 1, 0}});
  ASSERT_EQ(triangles.size(), 2U);
  EXPECT_EQ(triangles[0], (std::array{3, 0, 1}));
}

TEST(TriangulatePolygon, CutsADartInside) {
  const std::vector<Vec3> dart = {{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}};
  for (const double area : areas(dart)) EXPECT_EQ(area, 3);
}

TEST(TriangulatePolygon, FillsAStar) {
  std::vector<Vec3> star;
  for (int i = 0; i < 14; ++i) {
    const double radius = i % 2 == 0 ? 3 : 1, angle = std::acos(-1.0) * i / 7;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  double sum = 0;
  for (const double area : areas(star)) {
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_NEAR(sum, 7 * 3 * std::sin(std::acos(-1.0) / 7), 1e-12);
}

TEST(TriangulatePolygon, MakesAFanWithoutEars) {
  EXPECT_EQ(triangulate_polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2U);
  EXPECT_EQ(triangulate_polygon(std::vector<Vec3>(5, Vec3::Zero())).size(), 3U);
  EXPECT_TRUE(triangulate_polygon({{0, 0, 0}, {1, 0, 0}}).empty());
}

}  // namespace
}  // namespace surfmesh
