// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/curve_kinks.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "support/errors.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

std::vector<double> kinks(std::function<Vec3(double)> function) {
  return curve_kinks(CallableSpaceCurve(std::move(function)));
}

/// The outline of a regular polygon, each side over an equal part of t.
Vec3 polygon(int sides, double t, double radius = 1) {
  const double side = std::min(std::floor(t * sides), sides - 1.0);
  const double share = t * sides - side;
  const auto corner = [&](double i) {
    return Vec3(radius * std::cos(2 * pi * i / sides), radius * std::sin(2 * pi * i / sides), 0);
  };
  return (1 - share) * corner(side) + share * corner(side + 1);
}

void expect_near(const std::vector<double>& found, const std::vector<double>& wanted,
                 double tolerance) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], tolerance);
}

TEST(CurveKinks, FindsCornersOfPolygons) {
  for (const int sides : {3, 4, 7, 30, 60}) {
    std::vector<double> wanted;
    for (int i = 1; i < sides; ++i) wanted.push_back(double(i) / sides);
    expect_near(kinks([=](double t) { return polygon(sides, t); }), wanted, 1e-10);
  }
}

TEST(CurveKinks, FindsManyCorners) {
  // A gear wheel of 100 teeth turns four times at each.
  const auto radius = [](double t) {
    const double of_tooth = 100 * t - std::floor(100 * t);
    return 1 + 0.05 * std::clamp(20 * std::abs(of_tooth - 0.5) - 5, -1.0, 1.0);
  };
  const std::vector<double> found = kinks([&](double t) -> Vec3 {
    return {radius(t) * std::cos(2 * pi * t), radius(t) * std::sin(2 * pi * t), 0};
  });
  EXPECT_EQ(found.size(), 400u);
}

TEST(CurveKinks, LeavesSmoothCurvesWhole) {
  EXPECT_TRUE(kinks([](double t) -> Vec3 { return {t, 2 * t, -t}; }).empty());
  EXPECT_TRUE(kinks([](double t) -> Vec3 {
                return {std::cos(2 * pi * t), std::sin(2 * pi * t), 0};
              }).empty());
  EXPECT_TRUE(kinks([](double t) -> Vec3 { return {t, std::sin(40 * t), 0}; }).empty());
  // Rounded corners of radii down to 1e-7.
  for (const double steepness : {10.0, 1e3, 1e5, 1e7}) {
    const auto log_cosh = [](double x) {
      return std::abs(x) + std::log1p(std::exp(-2 * std::abs(x)));
    };
    EXPECT_TRUE(kinks([=](double t) -> Vec3 {
                  return {t, log_cosh(steepness * (t - 0.37)) / steepness, 0};
                }).empty())
        << steepness;
  }
}

TEST(CurveKinks, LooksAtDirectionsNotAtSpeeds) {
  // Slower by a hundred behind the middle, and standing still at it.
  EXPECT_TRUE(kinks([](double t) -> Vec3 {
                return {t < 0.5 ? t : 0.5 + (t - 0.5) / 100, 0, 0};
              }).empty());
  EXPECT_TRUE(kinks([](double t) -> Vec3 { return {std::pow(t - 0.4, 3), 0, 0}; }).empty());
  // A corner whose sides have speeds of 1 and 50.
  expect_near(kinks([](double t) -> Vec3 {
                return t < 0.7123 ? Vec3(t, 0, 0) : Vec3(0.7123, 50 * (t - 0.7123), 0);
              }),
              {0.7123}, 1e-9);
}

TEST(CurveKinks, FindsCusps) {
  expect_near(kinks([](double t) -> Vec3 {
                const double s = t - 0.37;
                return {s * s, s * s * s, 0};
              }),
              {0.37}, 1e-5);
  // An astroid, also far from the origin.
  for (const double offset : {0.0, 10.0, 100.0, 1000.0}) {
    const auto astroid = [=](double t) -> Vec3 {
      return {offset + std::pow(std::cos(2 * pi * t), 3),
              offset + std::pow(std::sin(2 * pi * t), 3), 0};
    };
    expect_near(kinks(astroid), {0.25, 0.5, 0.75}, 1e-3);
  }
}

TEST(CurveKinks, FindsKinksFarFromTheOrigin) {
  const Vec3 far(1e5, -3e5, 2e5);
  expect_near(kinks([&](double t) -> Vec3 { return far + polygon(4, t); }), {0.25, 0.5, 0.75},
              1e-5);
  EXPECT_TRUE(kinks([&](double t) -> Vec3 {
                return far + Vec3(std::cos(2 * pi * t), std::sin(2 * pi * t), 0);
              }).empty());
}

TEST(CurveKinks, LeavesSlightBendsAlone) {
  const auto bent_by = [](double degrees) {
    const double slope = std::tan(degrees * pi / 180);
    return kinks([=](double t) -> Vec3 { return {t, slope * std::max(0.0, t - 0.6), 0}; });
  };
  EXPECT_TRUE(bent_by(2).empty());
  expect_near(bent_by(5), {0.6}, 1e-10);
}

// Along the edge of a disc, the condition that one is inside is true or false by rounding.
TEST(CurveKinks, RefusesCurvesThatJumpToAndFro) {
  const std::string error = error_of([] {
    kinks([](double t) -> Vec3 {
      const double x = 0.2 * std::cos(2 * pi * t), y = 0.2 * std::sin(2 * pi * t);
      return {x, y, x * x + y * y < 0.04 ? 1.0 : 0.0};
    });
  });
  EXPECT_NE(error.find("it turns sharply at more than 2000 places"), std::string::npos) << error;
}

TEST(CurveKinks, IsEmptyForAPoint) {
  EXPECT_TRUE(kinks([](double) -> Vec3 { return {1, 2, 3}; }).empty());
}

}  // namespace
}  // namespace surfmesh
