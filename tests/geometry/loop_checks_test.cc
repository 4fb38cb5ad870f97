// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/loop_checks_detail.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

using std::numbers::pi;

LoopCurves circle(double u, double v, double radius, double start = 0) {
  const auto curve = std::make_shared<CallableCurve>([=](double t) {
    const double angle = start + 2 * pi * t;
    return Uv{u + radius * std::cos(angle), v + radius * std::sin(angle)};
  });
  return {{"circle", curve, true, {}}};
}

TEST(LoopArea, HasTheSignOfTheDirection) {
  LoopCurves loop = circle(3, 4, 2);
  EXPECT_NEAR(signed_area(loop), 8 * pi, 0.05);
  loop[0].is_along = false;
  EXPECT_NEAR(signed_area(loop), -8 * pi, 0.05);
}

TEST(LoopCrossing, IsFoundBetweenLoops) {
  EXPECT_TRUE(crossing({circle(0, 0, 1), circle(1, 0, 1)}));
  EXPECT_FALSE(crossing({circle(0, 0, 1), circle(2.5, 0, 1)}));
}

TEST(LoopCrossing, IsFoundInOneLoop) {
  const auto eight = std::make_shared<CallableCurve>([](double t) {
    return Uv{std::sin(2 * pi * t + 0.3), std::sin(4 * pi * t + 0.6)};
  });
  EXPECT_TRUE(crossing({{{"eight", eight, true, {}}}}));
}

TEST(LoopCrossing, IsNotSeenBetweenCirclesThatAreNear) {
  // The chords of 64 samples are off by 1e-3 of the radius.
  EXPECT_FALSE(crossing({circle(0, 0, 1), circle(0, 0, 1 - 1e-5, 0.05)}));
}

TEST(LoopOutside, IsToldWithItsPlace) {
  EXPECT_FALSE(place_outside(circle(0, 0, 1), {-1, 1, -1, 1}));
  const auto place = place_outside(circle(0.5, 0, 1), {-1, 1, -1, 1});
  ASSERT_TRUE(place);
  EXPECT_EQ(*place, "contour circle at t = 0, (u,v) = (1.5, 0)");
}

TEST(LoopInside, KnowsItsPoints) {
  EXPECT_TRUE(is_inside(circle(0, 0, 1), {0.5, -0.5}));
  EXPECT_FALSE(is_inside(circle(0, 0, 1), {0.8, 0.8}));
}

}  // namespace
}  // namespace surfmesh
