// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/metric_ellipses.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/meshes.hh"

namespace surfmesh {
namespace {

constexpr PictureFrame kFrame = {{0, 0}, 400, 400};

/// 20 pixels a unit, v upwards.
PicturePoint place(Uv uv) { return {20 * uv.u, 400 - 20 * uv.v}; }

PicturePoint extent(const PicturePoints& outline) {
  const auto [left, right] = std::minmax_element(
      outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return {right->x - left->x, bottom->y - top->y};
}

TEST(MetricEllipses, AreAsWideAsEdgesShouldBeLong) {
  // Lengths of 2 along u and 1 along v.
  const PolyMesh mesh = testing::plane_grid(20, 20, {0.25, 0, 1});
  const MetricEllipses ellipses = metric_ellipses(mesh, 0, place, kFrame);
  ASSERT_FALSE(ellipses.outlines.empty());
  EXPECT_EQ(ellipses.factor, 1);
  for (const PicturePoints& outline : ellipses.outlines) {
    EXPECT_NEAR(extent(outline).x, 0.92 * 2 * 20, 0.01);
    EXPECT_NEAR(extent(outline).y, 0.92 * 20, 0.01);
  }
}

TEST(MetricEllipses, TurnWithTheMetric) {
  // Long along the rising diagonal: M = R diag(1/4, 1) R' for 45 degrees.
  const PolyMesh mesh = testing::plane_grid(20, 20, {0.625, -0.375, 0.625});
  const MetricEllipses ellipses = metric_ellipses(mesh, 0, place, kFrame);
  ASSERT_FALSE(ellipses.outlines.empty());
  const PicturePoints& outline = ellipses.outlines.front();
  double longest = 0, rise = 0;
  for (std::size_t i = 0; i < 20; ++i) {  // opposite points
    const PicturePoint &a = outline[i], &b = outline[i + 20];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length <= longest) continue;
    longest = length;
    rise = (a.y - b.y) / (b.x - a.x);  // upwards
  }
  EXPECT_NEAR(longest, 0.92 * 2 * 20, 0.3);
  EXPECT_NEAR(rise, 1, 0.2);
}

TEST(MetricEllipses, DoNotOverlapOrLeaveTheFrame) {
  const PolyMesh mesh = testing::plane_grid(20, 20, {0.1, 0, 0.1});
  const MetricEllipses ellipses = metric_ellipses(mesh, 0, place, kFrame);
  EXPECT_GT(ellipses.outlines.size(), 10U);
  EXPECT_LT(ellipses.outlines.size(), 100U);
  std::vector<PicturePoint> middles;
  for (const PicturePoints& outline : ellipses.outlines) {
    for (const PicturePoint& point : outline) {
      EXPECT_TRUE(point.x >= 0 && point.x <= 400 && point.y >= 0 && point.y <= 400);
    }
    const PicturePoint middle{0.5 * (outline[0].x + outline[20].x),
                              0.5 * (outline[0].y + outline[20].y)};
    for (const PicturePoint& other : middles) {
      EXPECT_GT(std::hypot(middle.x - other.x, middle.y - other.y), 0.92 * 20 / std::sqrt(0.1) - 2);
    }
    middles.push_back(middle);
  }
}

TEST(MetricEllipses, AreLargerWhereTheyCouldNotBeSeen) {
  const PolyMesh mesh = testing::plane_grid(20, 20, {100, 0, 100});
  const MetricEllipses ellipses = metric_ellipses(mesh, 0, place, kFrame);
  EXPECT_NEAR(ellipses.factor, 7, 1e-9);
  EXPECT_EQ(metric_ellipses(mesh, 5, place, kFrame).outlines.size(), 0U);
}

}  // namespace
}  // namespace surfmesh
