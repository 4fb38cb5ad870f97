// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/loop_checks.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "surfmesh/model/loop_region.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

LoopCurves circle_loop(double u, double v, double radius, double start = 0) {
  const auto curve = std::make_shared<CallableCurve>([=](double t) {
    const double angle = start + 2 * pi * t;
    return Uv{u + radius * std::cos(angle), v + radius * std::sin(angle)};
  });
  return {{"circle", curve, true, {}}};
}

TEST(LoopArea, HasTheSignOfTheDirection) {
  LoopCurves loop = circle_loop(3, 4, 2);
  EXPECT_NEAR(signed_area(loop), 8 * pi, 0.05);
  loop[0].is_along = false;
  EXPECT_NEAR(signed_area(loop), -8 * pi, 0.05);
}

TEST(LoopCrossing, IsFoundBetweenLoops) {
  EXPECT_TRUE(crossing({circle_loop(0, 0, 1), circle_loop(1, 0, 1)}));
  EXPECT_FALSE(crossing({circle_loop(0, 0, 1), circle_loop(2.5, 0, 1)}));
}

TEST(LoopCrossing, IsFoundInOneLoop) {
  const auto eight = std::make_shared<CallableCurve>([](double t) {
    return Uv{std::sin(2 * pi * t + 0.3), std::sin(4 * pi * t + 0.6)};
  });
  EXPECT_TRUE(crossing({{{"eight", eight, true, {}}}}));
}

TEST(LoopCrossing, IsNotSeenBetweenCirclesThatAreNear) {
  // The chords of 64 samples are off by 1e-3 of the radius.
  EXPECT_FALSE(crossing({circle_loop(0, 0, 1), circle_loop(0, 0, 1 - 1e-5, 0.05)}));
}

TEST(LoopNearParts, AreFoundBetweenLoops) {
  for (const double gap : {1e-5, 1e-9, 0.0}) {
    const auto found = near_parts({circle_loop(0, 0, 1), circle_loop(2 + gap, 0, 1, 0.3)}, 1e-4);
    ASSERT_EQ(found.size(), 1u) << gap;
    EXPECT_NEAR(found[0].at_a.u, 1, 1e-6);
    EXPECT_NEAR(found[0].at_b.u - found[0].at_a.u, gap, 1e-8);
    EXPECT_NEAR(found[0].at_a.v, 0, 1e-4);
  }
  EXPECT_TRUE(near_parts({circle_loop(0, 0, 1), circle_loop(2.01, 0, 1, 0.3)}, 1e-4).empty());
}

TEST(LoopNearParts, AreFoundAlongTheWholeLoop) {
  EXPECT_EQ(near_parts({circle_loop(0, 0, 1), circle_loop(0, 0, 1 - 1e-5, 0.05)}, 1e-4).size(), 1u);
}

TEST(LoopNearParts, AreFoundInOneLoop) {
  const auto dumbbell = [](double waist) {
    return LoopCurves{{"dumbbell",
                       std::make_shared<CallableCurve>([=](double t) {
                         const double c = std::cos(2 * pi * t + 0.1);
                         return Uv{c, (waist + c * c) * std::sin(2 * pi * t + 0.1)};
                       }),
                       true,
                       {}}};
  };
  EXPECT_EQ(near_parts({dumbbell(1e-5)}, 1e-4).size(), 1u);
  EXPECT_TRUE(near_parts({dumbbell(1e-2)}, 1e-4).empty());
}

TEST(LoopNearParts, AreNotFoundAtCornersAndCusps) {
  const auto star = std::make_shared<CallableCurve>([](double t) {
    return Uv{std::pow(std::cos(2 * pi * t), 3), std::pow(std::sin(2 * pi * t), 3)};
  });
  EXPECT_TRUE(near_parts({{{"star", star, true, {}}}}, 1e-4).empty());
}

TEST(LoopNearParts, AreNotFoundAlongAShortContour) {
  const auto slit = [](double width) {
    const Uv corners[] = {{0, 0}, {1, 0}, {1, width}, {0, width}};
    LoopCurves loop;
    for (int i = 0; i < 4; ++i) {
      const auto side = std::make_shared<SegmentCurve>(corners[i], corners[(i + 1) % 4]);
      loop.push_back({"side" + std::to_string(i), side, true, {}});
    }
    return loop;
  };
  const auto found = near_parts({circle_loop(0, 0, 2), slit(1e-4)}, 1e-4);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].a + " " + found[0].b, "side0 side2");
}

TEST(LoopNearParts, AreNotFoundWhereThereIsNoExtent) {
  const auto spike = std::make_shared<CallableCurve>([](double t) {
    return Uv{std::cos(2 * pi * t), 0};
  });
  EXPECT_TRUE(near_parts({{{"spike", spike, true, {}}}}, 1e-4).empty());
}

TEST(LoopNearParts, DoNotDependOnTheScaleOfTheParameters) {
  const auto stretched = [](double u) {
    return LoopCurves{{"circle",
                       std::make_shared<CallableCurve>([=](double t) {
                         return Uv{1e6 * (u + std::cos(2 * pi * t)), 1e-3 * std::sin(2 * pi * t)};
                       }),
                       true,
                       {}}};
  };
  EXPECT_EQ(near_parts({stretched(0), stretched(2.00001)}, 1e-4).size(), 1u);
  EXPECT_TRUE(near_parts({stretched(0), stretched(2.01)}, 1e-4).empty());
}

TEST(LoopOutside, IsToldWithItsPlace) {
  EXPECT_FALSE(find_point_outside(circle_loop(0, 0, 1), {-1, 1, -1, 1}));
  const auto place = find_point_outside(circle_loop(0.5, 0, 1), {-1, 1, -1, 1});
  ASSERT_TRUE(place);
  EXPECT_EQ(*place, "contour circle at t = 0, (u,v) = (1.5, 0)");
}

TEST(LoopInside, KnowsItsPoints) {
  const LoopCurves loop = circle_loop(0, 0, 1);
  const LoopRegion region(loop);
  EXPECT_TRUE(region.contains({0.5, -0.5}));
  EXPECT_FALSE(region.contains({0.8, 0.8}));
}

TEST(LoopInside, LetsNoRayThroughWhereALoopCloses) {
  const LoopCurves loop = circle_loop(0, 0, 1);
  const LoopRegion region(loop);
  // The circle ends at v = -2.4e-16, not at 0 where it begins.
  for (const double v : {0.0, -1e-17, -1.1e-16, -2e-16, 1e-16}) {
    EXPECT_TRUE(region.contains({-0.9, v})) << v;
    EXPECT_TRUE(region.contains({0.999, v})) << v;
    EXPECT_FALSE(region.contains({-2, v})) << v;
    EXPECT_FALSE(region.contains({2, v})) << v;
  }
}

TEST(LoopInside, KnowsPointsBetweenTheCurveAndItsChords) {
  const LoopCurves loop = circle_loop(0, 0, 1);
  const LoopRegion region(loop);
  // The chords of 64 samples are off by 1e-3 of the radius.
  for (int i = 0; i < 100; ++i) {
    const double c = std::cos(0.1 * i), s = std::sin(0.1 * i);
    for (const double gap : {1e-4, 1e-7, 1e-10}) {
      EXPECT_TRUE(region.contains({(1 - gap) * c, (1 - gap) * s})) << i << " " << gap;
      EXPECT_FALSE(region.contains({(1 + gap) * c, (1 + gap) * s})) << i << " " << gap;
    }
  }
}

}  // namespace
}  // namespace surfmesh
