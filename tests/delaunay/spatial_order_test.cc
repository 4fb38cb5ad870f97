// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/spatial_order.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/domain_meshes.hh"

namespace surfmesh {
namespace {

using testing::random_points;

/// True if every index from 0 to count is there once.
bool is_permutation_of(std::vector<int> order, std::size_t count) {
  std::vector<int> expected(count);
  std::iota(expected.begin(), expected.end(), 0);
  std::sort(order.begin(), order.end());
  return order == expected;
}

double distance(Uv a, Uv b) { return std::hypot(a.u - b.u, a.v - b.v); }

/// Mean distance of following points of the last half, which is one round.
double mean_step(const std::vector<Uv>& points, const std::vector<int>& order) {
  double sum = 0;
  const std::size_t first = order.size() / 2 + order.size() / 8;
  for (std::size_t i = first; i + 1 < order.size(); ++i) {
    sum += distance(points[static_cast<std::size_t>(order[i])],
                    points[static_cast<std::size_t>(order[i + 1])]);
  }
  return sum / static_cast<double>(order.size() - 1 - first);
}

TEST(SpatialOrder, IsAPermutation) {
  for (const int count : {0, 1, 2, 3, 17, 1000}) {
    const std::vector<Uv> points = random_points(count, 3);
    EXPECT_TRUE(is_permutation_of(spatial_order(points), points.size())) << count;
  }
}

TEST(SpatialOrder, IsAPermutationOfEqualPoints) {
  EXPECT_TRUE(is_permutation_of(spatial_order(std::vector<Uv>(50, Uv{0.5, 0.5})), 50));
}

TEST(SpatialOrder, IsAPermutationOfPointsOnALine) {
  std::vector<Uv> points;
  for (int i = 0; i < 50; ++i) points.push_back({1e6 * i, 3});
  EXPECT_TRUE(is_permutation_of(spatial_order(points), 50));
}

TEST(SpatialOrder, IsTheSameTwice) {
  const std::vector<Uv> points = random_points(1000, 3);
  EXPECT_EQ(spatial_order(points), spatial_order(points));
}

TEST(SpatialOrder, DoesNotDependOnTheScaleOfTheParameters) {
  std::vector<Uv> points = random_points(1000, 3);
  const std::vector<int> order = spatial_order(points);
  for (Uv& p : points) p = {1048576 * p.u, p.v / 1024};
  EXPECT_EQ(spatial_order(points), order);
}

TEST(SpatialOrder, PutsNeighboursNextToEachOther) {
  const std::vector<Uv> points = random_points(10'000, 3);
  // The half of the points that comes last is 1/√5000 = 0.014 apart; random pairs are 0.52.
  EXPECT_LT(mean_step(points, spatial_order(points)), 2 / std::sqrt(5000.0));
}

TEST(SpatialOrder, SpreadsTheFirstPointsOverTheWhole) {
  const std::vector<Uv> points = random_points(10'000, 3);
  const std::vector<int> order = spatial_order(points);
  std::array<int, 4> quarters{};
  for (std::size_t i = 0; i < 200; ++i) {
    const Uv p = points[static_cast<std::size_t>(order[i])];
    ++quarters[(p.u < 0.5 ? 0u : 1u) + (p.v < 0.5 ? 0u : 2u)];
  }
  for (const int count : quarters) EXPECT_GT(count, 20);
}

TEST(CellOrder, HasEveryPointOnce) {
  for (const int count : {0, 1, 2, 5, 1000}) {
    std::vector<int> order = cell_order(random_points(count, 3));
    std::sort(order.begin(), order.end());
    for (int i = 0; i < count; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
    EXPECT_EQ(order.size(), static_cast<std::size_t>(count));
  }
}

TEST(CellOrder, PutsNeighboursNextToEachOther) {
  const std::vector<Uv> points = random_points(10'000, 3);
  // Up to four points share a cell, in any order.
  EXPECT_LT(mean_step(points, cell_order(points)), 3 / std::sqrt(10'000.0));
}

TEST(CellOrder, KeepsTheOrderOfPointsAtOnePlace) {
  EXPECT_EQ(cell_order(std::vector<Uv>(5, {0.3, 0.4})), (std::vector<int>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace surfmesh
