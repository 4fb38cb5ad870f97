// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/interval.hh"

#include <gtest/gtest.h>

#include <limits>

namespace surfmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kAll = {};

TEST(Interval, IsUnboundedUntilItIsSet) {
  EXPECT_EQ(kAll, (Interval{-kInfinity, kInfinity}));
  EXPECT_TRUE(kAll.contains(1e300));
}

TEST(Interval, HasAMiddleAndAWidth) {
  EXPECT_EQ((Interval{-1, 3}.middle()), 1);
  EXPECT_EQ((Interval{-1, 3}.width()), 4);
  EXPECT_EQ(Interval::of(2), (Interval{2, 2}));
}

TEST(Interval, AddsAndSubtractsItsEnds) {
  EXPECT_EQ((Interval{1, 2} + Interval{10, 30}), (Interval{11, 32}));
  EXPECT_EQ((Interval{1, 2} - Interval{10, 30}), (Interval{-29, -8}));
  EXPECT_EQ((-Interval{1, 2}), (Interval{-2, -1}));
}

TEST(Interval, MultipliesOverAllSigns) {
  EXPECT_EQ((Interval{-2, 3} * Interval{-5, 7}), (Interval{-15, 21}));
  EXPECT_EQ((Interval{-2, -1} * Interval{4, 5}), (Interval{-10, -4}));
  EXPECT_EQ((Interval{0, 1} * Interval{1, kInfinity}), (Interval{0, kInfinity}));
}

TEST(Interval, DividesOnEitherSideOfZero) {
  EXPECT_EQ((Interval{1, 2} / Interval{4, 8}), (Interval{0.125, 0.5}));
  EXPECT_EQ((Interval{1, 2} / Interval{0, 2}), (Interval{0.5, kInfinity}));
  EXPECT_EQ((Interval{1, 2} / Interval{-2, 0}), (Interval{-kInfinity, -0.5}));
  EXPECT_EQ((Interval{0, 1} / Interval{0, 1}), (Interval{0, kInfinity}));
}

TEST(Interval, IsUnboundedAfterDivisionThroughZero) {
  EXPECT_EQ((Interval{1, 2} / Interval{-1, 2}), kAll);
  EXPECT_EQ((Interval{1, 2} / Interval{0, 0}), kAll);
}

TEST(Interval, IsUnboundedWhereNothingIsDefined) {
  const Interval infinite = Interval::of(kInfinity);
  EXPECT_EQ(infinite - infinite, kAll);
  EXPECT_EQ(infinite / infinite, kAll);
  EXPECT_EQ(Interval::of(0) * infinite, kAll);
  EXPECT_EQ(sqrt(Interval{-2, -1}), kAll);
  EXPECT_EQ(defined(Interval::of(std::numeric_limits<double>::quiet_NaN())), kAll);
}

TEST(Interval, IsSquaredTighterThanMultiplied) {
  EXPECT_EQ(square(Interval{-1, 2}), (Interval{0, 4}));
  EXPECT_EQ(square(Interval{-3, -2}), (Interval{4, 9}));
}

TEST(Interval, HasAbsoluteValuesAndRoots) {
  EXPECT_EQ(abs(Interval{-3, 2}), (Interval{0, 3}));
  EXPECT_EQ(abs(Interval{-3, -2}), (Interval{2, 3}));
  EXPECT_EQ(sqrt(Interval{-1, 4}), (Interval{0, 2}));
}

TEST(Interval, HasAMinimumAMaximumAndAHull) {
  const Interval a = {0, 5}, b = {1, 3};
  EXPECT_EQ(min(a, b), (Interval{0, 3}));
  EXPECT_EQ(max(a, b), (Interval{1, 5}));
  EXPECT_EQ(hull(Interval{0, 1}, Interval{3, 4}), (Interval{0, 4}));
}

}  // namespace
}  // namespace surfmesh
