// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/boundary_corners.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/domain_meshes.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::circle;
using testing::isotropic_metric;
using testing::kUnitSquare;

std::vector<BoundaryCorner> corners_of(const std::vector<std::vector<Uv>>& loops,
                                       const Metric& metric = {1, 0, 1}) {
  const auto triangles = triangulate_boundary(loops, testing::constant_field(metric)).delaunay;
  std::vector<std::size_t> sizes;
  for (const auto& loop : loops) sizes.push_back(loop.size());
  return boundary_corners(triangles->mesh(), sizes);
}

TEST(BoundaryCorners, OfASquareAreRightAngles) {
  const auto corners = corners_of({kUnitSquare});
  ASSERT_EQ(corners.size(), 4u);
  for (const BoundaryCorner& corner : corners) {
    EXPECT_NEAR(corner.angle, pi / 2, 1e-15);
    EXPECT_EQ(corner.quads, 1);
  }
  EXPECT_EQ(corners[0].ahead.c, 1);
  EXPECT_EQ(corners[0].ahead.s, 0);
  EXPECT_EQ(corners[1].ahead.s, 1);
  EXPECT_EQ(corners[2].ahead.c, -1);
}

/// In the metric, the unit square is a rhombus with an angle of 60° at its first corner.
TEST(BoundaryCorners, TakeTheirAnglesFromTheMetric) {
  const auto corners = corners_of({kUnitSquare}, {1, 0.5, 1});
  for (const std::size_t k : {0u, 1u, 2u, 3u}) {
    EXPECT_NEAR(corners[k].angle, k % 2 == 0 ? pi / 3 : 2 * pi / 3, 1e-14);
    EXPECT_EQ(corners[k].quads, 1);
  }
}

TEST(BoundaryCorners, PointAheadAlongTheNextSideInTheRootFrame) {
  const Metric metric{4, 1.5, 2};
  const auto corners = corners_of({kUnitSquare}, metric);
  for (std::size_t k = 0; k < 4; ++k) {
    const Uv side = kUnitSquare[(k + 1) % 4] - kUnitSquare[k];
    const Uv step = RootFrame(metric).step(corners[k].ahead);
    EXPECT_NEAR(cross(step, side), 0, 1e-14);
    EXPECT_GT(step.u * side.u + step.v * side.v, 0);
  }
}

TEST(BoundaryCorners, FitThreeQuadsWhereTheyAreReEntrant) {
  const auto corners = corners_of({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  EXPECT_NEAR(corners[3].angle, 1.5 * pi, 1e-15);
  EXPECT_EQ(corners[3].quads, 3);
}

TEST(BoundaryCorners, FitTwoQuadsOnStraightSides) {
  const auto corners = corners_of({{{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_NEAR(corners[1].angle, pi, 1e-15);
  EXPECT_EQ(corners[1].quads, 2);
}

TEST(BoundaryCorners, FitAQuadHoweverSharpTheyAre) {
  for (const double angle : {1.0, 10.0, 60.0}) {
    const double a = angle * pi / 180;
    const auto corners = corners_of({{{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}}});
    EXPECT_NEAR(corners[0].angle, a, 1e-13);
    EXPECT_EQ(corners[0].quads, 1) << angle;
  }
}

TEST(BoundaryCorners, OfAHoleAreSeenFromOutsideOfIt) {
  const auto corners =
      corners_of({{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}});
  ASSERT_EQ(corners.size(), 8u);
  for (std::size_t k = 4; k < 8; ++k) {
    EXPECT_NEAR(corners[k].angle, 1.5 * pi, 1e-15);
    EXPECT_EQ(corners[k].quads, 3);
  }
}

/// The angles of a polygon are those of (n − 2) triangles; those of a hole the ones of n + 2.
TEST(BoundaryCorners, AddUpToTheAnglesOfThePolygon) {
  const auto corners =
      corners_of({circle({0, 0}, 1, 17), circle({0, 0}, 0.4, -9)}, isotropic_metric(0.3));
  double outer = 0, inner = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) (k < 17 ? outer : inner) += corners[k].angle;
  EXPECT_NEAR(outer, 15 * pi, 1e-12);
  EXPECT_NEAR(inner, 11 * pi, 1e-12);
}

}  // namespace
}  // namespace surfmesh
