// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/star.hh"

#include <gtest/gtest.h>

#include "improve/star_of.hh"
#include "support/domain_meshes.hh"

namespace surfmesh {
namespace {

constexpr Metric kPlane{1, 0, 1};

/// A fan of `count` triangles around the origin with radius 1; the centre is vertex 0.
std::unique_ptr<DelaunayMesh> fan(int count) {
  std::vector<Uv> points = testing::circle({0, 0}, 1, count);
  points.insert(points.begin(), Uv{0, 0});
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  auto delaunay = std::make_unique<DelaunayMesh>(points, triangles);
  for (int i = 0; i <= count; ++i) delaunay->metric(VertexHandle(i)) = kPlane;
  return delaunay;
}

TEST(Star, HasAllNeighboursCounterClockwise) {
  const Star star = star_of(*fan(7));
  ASSERT_EQ(star.ring().size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_GT(cross(star.ring()[i].uv, star.ring()[(i + 1) % 7].uv), 0);
  }
}

TEST(Star, IsNotCollectedAtTheBoundary) {
  const auto delaunay = fan(7);
  Star star;
  for (int i = 1; i <= 7; ++i) EXPECT_FALSE(star.collect(*delaunay, VertexHandle(i)));
}

TEST(Star, OfSixUnitTrianglesHasQualityOne) {
  EXPECT_NEAR(star_of(*fan(6)).quality({{0, 0}, kPlane}), 1, 1e-15);
}

TEST(Star, IsWorseWithItsVertexOffTheMiddle) {
  const Star star = star_of(*fan(6));
  double last = 1;
  for (const double u : {0.1, 0.2, 0.4, 0.6, 0.8}) {
    const double quality = star.quality({{u, 0}, kPlane});
    EXPECT_LT(quality, last);
    EXPECT_GT(quality, 0);
    last = quality;
  }
}

TEST(Star, IsInvertedWithItsVertexOnOrBeyondTheRing) {
  const Star star = star_of(*fan(4));
  EXPECT_LT(star.quality({{1, 0}, kPlane}), 0);
  EXPECT_LT(star.quality({{0.8, 0.8}, kPlane}), 0);
  EXPECT_LT(star.quality({{0.5, 0.5 + 1e-12}, kPlane}), 0);
}

TEST(Star, HasItsExactQualityOnlyAboveTheBound) {
  const Star star = star_of(*fan(6));
  const MetricCorner p{{0.3, 0.1}, kPlane};
  const double quality = star.quality(p);
  for (const double enough : {-1.0, 0.0, 0.5 * quality})
    EXPECT_EQ(star.quality(p, enough), quality);
  for (const double enough : {quality, 0.5 * (1 + quality), 1.0})
    EXPECT_LE(star.quality(p, enough), enough);
}

TEST(Star, BeginsAtTheWorstTriangleWithTheSameTriangles) {
  Star star = star_of(*fan(6));
  const MetricCorner p{{0.3, 0.1}, kPlane};
  const Star before = star;
  star.begin_at_worst(p);
  EXPECT_EQ(star.quality(p), before.quality(p));
  EXPECT_EQ(star.quality(p), triangle_quality(p, star.ring().back(), star.ring().front()));
}

TEST(Star, IsInvertedWithoutAPlace) { EXPECT_LE(star_of(*fan(6)).quality({Uv(), kPlane}), 0); }

}  // namespace
}  // namespace surfmesh
