// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/pole_room.hh"

#include <gtest/gtest.h>

namespace surfmesh::detail {
namespace {

/// The pole is the side v = 1 of the unit square, its ring lies at v = 0.8.
constexpr PoleSide kPole = {{1, 0.8}, {1, 1}, {0, 1}, {0, 0.8}};

TEST(PoleRoom, IsClearWhereSegmentsAreFar) {
  EXPECT_FALSE(is_in_the_way(kPole, {0.2, 0.6}, {0.8, 0.6}));
  EXPECT_FALSE(is_in_the_way(kPole, {-1, 0}, {2, 0}));
}

TEST(PoleRoom, IsTakenBySegmentsNearTheRing) {
  EXPECT_TRUE(is_in_the_way(kPole, {0.2, 0.75}, {0.8, 0.75}));
}

TEST(PoleRoom, IsTakenBySegmentsThatCrossTheRing) {
  EXPECT_TRUE(is_in_the_way(kPole, {0.5, 0.5}, {0.5, 0.9}));
  EXPECT_TRUE(is_in_the_way(kPole, {0.2, 0.2}, {0.9, 1.5}));
}

TEST(PoleRoom, IsTakenBySegmentsBetweenRingAndPole) {
  EXPECT_TRUE(is_in_the_way(kPole, {0.5, 0.9}, {0.55, 0.9}));
}

}  // namespace
}  // namespace surfmesh::detail
