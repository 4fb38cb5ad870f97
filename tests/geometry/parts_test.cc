// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/parts.hh"

#include <gtest/gtest.h>

#include <vector>

namespace surfmesh {
namespace {

using Values = std::vector<double>;

TEST(Parts, EvenBreaksMakeEqualParts) {
  EXPECT_TRUE(even_breaks(1).empty());
  EXPECT_EQ(even_breaks(4), (Values{0.25, 0.5, 0.75}));
}

TEST(Parts, AreDividedEachOnItsOwn) {
  EXPECT_EQ(divided_parts({}, 2), (Values{0, 0.5, 1}));
  EXPECT_EQ(divided_parts({0.5}, 2), (Values{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(divided_parts({0.1}, 1), (Values{0, 0.1, 1}));
}

TEST(Parts, WidthIsThatBehindABreak) {
  EXPECT_DOUBLE_EQ(part_width({}, 0.3), 1);
  EXPECT_DOUBLE_EQ(part_width({0.25}, 0.1), 0.25);
  EXPECT_DOUBLE_EQ(part_width({0.25}, 0.25), 0.75);
  EXPECT_DOUBLE_EQ(part_width({0.25}, 1), 0.75);
}

TEST(Parts, BreaksOfAPieceRunAsItDoes) {
  EXPECT_EQ(breaks_between({0.25, 0.75}, 0, 0.5), (Values{0.5}));
  EXPECT_EQ(breaks_between({0.25, 0.75}, 1, 0), (Values{0.25, 0.75}));
  EXPECT_TRUE(breaks_between({0.25}, 0.25, 1).empty());
}

}  // namespace
}  // namespace surfmesh
