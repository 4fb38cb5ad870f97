// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/crossing_segments.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace surfmesh::detail {
namespace {

const NodeLoop kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

NodeLoop circle(double radius, std::size_t count, double phase = 0) {
  NodeLoop loop;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = phase + 2 * std::numbers::pi * static_cast<double>(i) / double(count);
    loop.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return loop;
}

TEST(CrossingSegments, AreNoneInASimpleLoop) {
  EXPECT_TRUE(crossing_segments({kSquare}).empty());
  EXPECT_TRUE(crossing_segments({circle(1, 100), circle(0.9, 100)}).empty());
}

TEST(CrossingSegments, AreFoundInALoopLikeAnEight) {
  const auto found = crossing_segments({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first.node + found[0].second.node, 2u);
}

TEST(CrossingSegments, AreThoseThatTouch) {
  const NodeLoop inside = {{0.5, 0}, {0.6, 0.5}, {0.4, 0.5}};
  // The two segments that end on the side of the square.
  EXPECT_EQ(crossing_segments({kSquare, inside}).size(), 2u);
}

TEST(CrossingSegments, AreNotThoseWithACommonEnd) {
  EXPECT_TRUE(crossing_segments({kSquare, {{0, 0}, {0.4, 0.8}, {0.8, 0.4}}}).empty());
  // Along each other from the common end on, they are.
  EXPECT_FALSE(crossing_segments({kSquare, {{0, 0}, {0.4, 0.8}, {0.5, 0}}}).empty());
}

TEST(CrossingSegments, OfTwoCirclesAreTwoASide) {
  // The corners of the inner one reach beyond the middles of the outer one's sides.
  const auto found = crossing_segments({circle(1, 6), circle(0.95, 6, std::numbers::pi / 6)});
  EXPECT_EQ(found.size(), 12u);
}

TEST(CrossingSegments, AreFoundWhateverTheScales) {
  NodeLoop eight = {{0, 0}, {1e9, 1e-9}, {1e9, 0}, {0, 1e-9}};
  EXPECT_EQ(crossing_segments({eight}).size(), 1u);
}

}  // namespace
}  // namespace surfmesh::detail
