// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/segment_distance.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

const Vec3 kStart(0, 0, 0), kEnd(2, 0, 0);

TEST(SegmentDistance, BesideTheSegmentIsThatOfItsLine) {
  EXPECT_DOUBLE_EQ(segment_distance({1, -3, 4}, kStart, kEnd), 5);
}

TEST(SegmentDistance, BeyondAnEndIsThatOfTheEnd) {
  EXPECT_DOUBLE_EQ(segment_distance({5, -4, 0}, kStart, kEnd), 5);
  EXPECT_DOUBLE_EQ(segment_distance({-3, 0, 4}, kStart, kEnd), 5);
}

TEST(SegmentDistance, FromAPointIsThatOfThePoint) {
  EXPECT_DOUBLE_EQ(segment_distance({3, 0, 0}, kStart, kStart), 3);
}

}  // namespace
}  // namespace surfmesh
