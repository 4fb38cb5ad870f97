// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/contour_curvature.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/waves.hh"

namespace surfmesh {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

CallableSpaceCurve ellipse(double a, double b, double speed = 0) {
  return CallableSpaceCurve([=](double t) -> Vec3 {
    const double angle = kTwoPi * (t + speed * t * (1 - t));
    return {a * std::cos(angle), b * std::sin(angle), 1};
  });
}

const CallableSpaceCurve kLine([](double t) -> Vec3 { return {t, 2 * t * t, 0}; });
const CallableSpaceCurve kStraight([](double t) -> Vec3 { return {t, 2 * t, 3}; });

std::vector<PlacedSize> sizes_of(const SpaceCurve& curve, double curvature = 0.25, double hmax = 10,
                                 double grade = 1.5) {
  Sizing sizing = testing::sizing_of(curvature, 0.001, hmax, 2);
  sizing.grade = grade;
  return contour_curvature_sizes(curve, resolve(sizing, 1));
}

TEST(ContourCurvature, IsThatOfACircle) {
  for (const double t : {0.0, 0.1, 0.5, 0.997, 1.0}) {
    EXPECT_NEAR(curve_curvature(ellipse(4, 4), t), 0.25, 1e-9) << t;
    EXPECT_NEAR(curve_curvature(ellipse(4, 4, 0.8), t), 0.25, 1e-9) << t;
  }
}

TEST(ContourCurvature, IsThatOfACurve) {
  // κ = 4 / (1 + 16 t²)^1.5 on the parabola y = 2 x².
  for (const double t : {0.1, 0.3, 0.7}) {
    const double exact = 4 / std::pow(1 + 16 * t * t, 1.5);
    EXPECT_NEAR(curve_curvature(kLine, t), exact, 1e-4 * exact) << t;
  }
  EXPECT_NEAR(curve_curvature(kStraight, 0.3), 0, 1e-9);
}

/// Two lines that meet at t = 0.37.
const CallableSpaceCurve kCorner([](double t) -> Vec3 { return {t, 2 * std::abs(t - 0.37), 0}; });

TEST(ContourCurvature, IsNoneAtACorner) {
  for (const double t : {0.37, 0.3701, 0.3695, 0.369, 0.372}) {
    EXPECT_LT(curve_curvature(kCorner, t), 1e-6) << t;
  }
  EXPECT_TRUE(sizes_of(kCorner).empty());
}

TEST(ContourCurvature, IsThatOfANarrowBend) {
  // A quarter of a circle whose length is a hundredth of that of the two lines beside it.
  const CallableSpaceCurve bend([](double t) -> Vec3 {
    const double s = 101 * t - 50, angle = std::clamp(s, 0.0, 1.0) * std::numbers::pi / 2;
    const Vec3 arc(std::sin(angle), 1 - std::cos(angle), 0);
    return s < 0 ? Vec3(s, 0, 0) : s > 1 ? Vec3(1, s, 0) : arc;
  });
  EXPECT_NEAR(curve_curvature(bend, 0.5), 1, 1e-3);
}

TEST(ContourCurvature, IsNoneOfAPoint) {
  EXPECT_EQ(curve_curvature(CallableSpaceCurve([](double) { return Vec3(1, 2, 3); }), 0.5), 0);
}

TEST(ContourCurvature, GivesSizesOfTheFactorTimesTheRadius) {
  const auto sizes = sizes_of(ellipse(4, 4));
  ASSERT_FALSE(sizes.empty());
  for (const PlacedSize& placed : sizes) {
    EXPECT_TRUE(placed.follows_segment);
    EXPECT_NEAR(placed.at_from.along, 1, 1e-6);
    EXPECT_NEAR(placed.at_to.across, 2, 1e-6);
  }
}

TEST(ContourCurvature, FollowsAChange) {
  // At the ends of the axes of an ellipse the radii are b²/a and a²/b.
  double least = 100, largest = 0;
  for (const PlacedSize& placed : sizes_of(ellipse(4, 1), 0.25, 100)) {
    least = std::min(least, placed.at_from.along);
    largest = std::max(largest, placed.at_from.along);
    EXPECT_LE((placed.to - placed.from).norm(), 8 * placed.at_from.along);
  }
  EXPECT_NEAR(least, 0.25 * 0.25, 1e-4);
  EXPECT_NEAR(largest, 0.25 * 16, 1e-2);
}

TEST(ContourCurvature, IsNothingOnAStraightOrHardlyCurvedContour) {
  EXPECT_TRUE(sizes_of(kStraight).empty());
  EXPECT_TRUE(sizes_of(ellipse(4, 4), 0.25, 0.9).empty());
}

TEST(ContourCurvature, IsClamped) {
  for (const PlacedSize& placed : sizes_of(ellipse(4, 1), 1e-4)) {
    EXPECT_GE(placed.at_from.along, 0.001);
  }
}

TEST(ContourCurvature, ReachesAnElementWithoutGradation) {
  for (const PlacedSize& placed : sizes_of(ellipse(4, 4), 0.25, 10, 0)) {
    EXPECT_NEAR(placed.radius, 0.5, 1e-6);
  }
}

}  // namespace
}  // namespace surfmesh
