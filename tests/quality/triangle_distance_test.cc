// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_distance.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace surfmesh::detail {
namespace {

const std::array<Vec3, 3> kTriangle = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};

TEST(TriangleDistance, InsideIsThatOfThePlane) {
  const TriangleDistance found = triangle_distance({0.5, 0.5, -3}, kTriangle);
  EXPECT_DOUBLE_EQ(found.distance, 3);
  EXPECT_TRUE(found.is_inside);
}

TEST(TriangleDistance, BesideASideIsThatOfTheSide) {
  const TriangleDistance found = triangle_distance({1, -3, 4}, kTriangle);
  EXPECT_DOUBLE_EQ(found.distance, 5);
  EXPECT_FALSE(found.is_inside);
}

TEST(TriangleDistance, BeyondACornerIsThatOfTheCorner) {
  EXPECT_DOUBLE_EQ(triangle_distance({5, -4, 0}, kTriangle).distance, 5);
}

TEST(TriangleDistance, OfATriangleWithoutAreaIsThatOfItsSides) {
  const std::array<Vec3, 3> flat = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  EXPECT_DOUBLE_EQ(triangle_distance({1.5, 0, 2}, flat).distance, 2);
}

}  // namespace
}  // namespace surfmesh::detail
