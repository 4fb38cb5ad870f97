// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/placed_size.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "support/analytic.hh"
#include "support/tensors.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

using testing::expect_near;

constexpr double kNoGrowth = std::numeric_limits<double>::infinity();

/// A point of the plane z = 0 with the axes of x and y.
TangentFrame flat(double x, double y, double z = 0) {
  return {{x, y, z}, Vec3::UnitX(), Vec3::UnitY()};
}

PlacedSize at_origin(double along, double across, double angle = 0) {
  PlacedSize placed;
  placed.from = placed.to = Vec3::Zero();
  placed.at_from = placed.at_to = {along, across};
  placed.angle = angle;
  return placed;
}

PlacedSize along_x(double length, const SizeLengths& from, const SizeLengths& to) {
  PlacedSize placed = at_origin(1, 1);
  placed.to = {length, 0, 0};
  placed.at_from = from;
  placed.at_to = to;
  return placed;
}

TEST(PlacedSize, HoldsWithinItsRadius) {
  PlacedSize placed = at_origin(0.2, 0.1, 0.3);
  placed.radius = 1;
  expect_near(*size_around(placed, flat(0.6, 0.7), kNoGrowth), size_tensor(0.2, 0.1, 0.3), 1e-15);
  EXPECT_FALSE(size_around(placed, flat(0.8, 0.7), kNoGrowth));
}

TEST(PlacedSize, HoldsInsideABox) {
  PlacedSize placed = at_origin(0.2, 0.1, 0.3);
  placed.is_box = true;
  placed.to = {1, 2, 3};
  const SizeTensor size = size_tensor(0.2, 0.1, 0.3);
  for (const auto& [x, y, z] : {std::array{0.5, 1.0, 1.5}, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}) {
    expect_near(*size_around(placed, flat(x, y, z), kNoGrowth), size, 1e-15);
  }
  EXPECT_FALSE(size_around(placed, flat(1.01, 1, 1), kNoGrowth));
  EXPECT_FALSE(size_around(placed, flat(0.5, 1, -0.01), kNoGrowth));
  placed.radius = 0.5;  // around a corner
  EXPECT_TRUE(size_around(placed, flat(1.3, 2.3), kNoGrowth));
  EXPECT_FALSE(size_around(placed, flat(1.4, 2.4), kNoGrowth));
}

TEST(PlacedSize, GrowsWithTheDistanceFromABox) {
  const double growth = std::log(1.5);
  PlacedSize placed = at_origin(0.1, 0.1);
  placed.is_box = true;
  placed.to = {1, 1, 1};
  expect_near(*size_around(placed, flat(3, 0.5), growth), isotropic(0.1 + 2 * growth), 1e-15);
  expect_near(*size_around(placed, flat(4, 5), growth), isotropic(0.1 + 5 * growth), 1e-15);
}

TEST(PlacedSize, ChangesLinearlyToTheOuterOne) {
  PlacedSize placed = at_origin(0.1, 0.1);
  placed.radius = 1;
  placed.outer = {{0.5, 0.3}, 0, 2};
  expect_near(*size_around(placed, flat(0, 2), kNoGrowth), {0.3, 0, 0.2}, 1e-15);
  expect_near(*size_around(placed, flat(0, 3), kNoGrowth), {0.5, 0, 0.3}, 1e-15);
  EXPECT_FALSE(size_around(placed, flat(0, 3.01), kNoGrowth));
}

TEST(PlacedSize, GrowsByTheGradePerUnitOfLength) {
  const double growth = std::log(1.5);
  PlacedSize placed = at_origin(0.1, 0.1);
  expect_near(*size_around(placed, flat(2, 0), growth), isotropic(0.1 + 2 * growth), 1e-15);
  placed.radius = 0.5;
  expect_near(*size_around(placed, flat(2, 0), growth), isotropic(0.1 + 1.5 * growth), 1e-15);
}

TEST(PlacedSize, GrowsByTheMetricLengthOfTheWay) {
  const double growth = 0.4;
  const PlacedSize placed = at_origin(0.5, 0.1);
  expect_near(*size_around(placed, flat(1, 0), growth), scaled({0.5, 0, 0.1}, 1 + growth * 2),
              1e-14);
  expect_near(*size_around(placed, flat(0, 1), growth), scaled({0.5, 0, 0.1}, 1 + growth * 10),
              1e-14);
}

TEST(PlacedSize, CountsTheWayOutOfThePlaneWithTheLargerSize) {
  const PlacedSize placed = at_origin(0.5, 0.1);
  expect_near(*size_around(placed, flat(0, 0, 1), 0.4), scaled({0.5, 0, 0.1}, 1 + 0.4 * 2), 1e-14);
}

TEST(PlacedSize, IsTheSameEverywhereAtGradeOne) {
  EXPECT_EQ(*size_around(at_origin(0.1, 0.1), flat(5, 6), growth_of_grade(1)), isotropic(0.1));
  EXPECT_TRUE(std::isinf(growth_of_grade(0)));
}

TEST(PlacedSize, ChangesAlongASegment) {
  PlacedSize placed = along_x(4, {0.1, 0.2}, {0.5, 0.6});
  placed.radius = 1;
  expect_near(*size_around(placed, flat(1, 0.5), kNoGrowth), {0.2, 0, 0.3}, 1e-15);
  expect_near(*size_around(placed, flat(4.5, 0), kNoGrowth), {0.5, 0, 0.6}, 1e-15);
}

TEST(PlacedSize, FollowsItsSegmentInAnyFrame) {
  PlacedSize placed = along_x(2, {0.4, 0.1}, {0.4, 0.1});
  placed.follows_segment = true;
  placed.radius = 1;
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  const TangentFrame turned{{1, 0, 0}, {c, s, 0}, {-s, c, 0}};
  expect_near(*size_around(placed, turned, kNoGrowth), size_tensor(0.4, 0.1, -angle), 1e-15);
  const TangentFrame upright{{1, 0, 0}, Vec3::UnitY(), Vec3::UnitZ()};
  expect_near(*size_around(placed, upright, kNoGrowth), isotropic(0.1), 1e-15);
}

TEST(PlacedSize, GrowsAlikeInBothLengthsIfItFollowsItsSegment) {
  PlacedSize placed = along_x(2, {0.1, 0.4}, {0.1, 0.4});
  placed.follows_segment = true;
  expect_near(*size_around(placed, flat(1, 0.5), 0.4), {0.3, 0, 0.6}, 1e-14);
  EXPECT_EQ(least_ratio(placed), 1);
}

TEST(PlacedSize, IsNeverBelowItsBound) {
  PlacedSize placed = along_x(2, {0.4, 0.1}, {0.2, 0.3});
  placed.radius = 0.1;
  for (int i = 0; i < 200; ++i) {
    const TangentFrame place = flat(0.1 * (i % 37) - 1, 0.13 * (i % 23) - 1.2);
    const double x = std::clamp(place.point.x(), 0.0, 2.0);
    const double rest = std::max(0.0, (place.point - Vec3(x, 0, 0)).norm() - reach(placed));
    const double bound = least_length(placed) + 0.4 * least_ratio(placed) * rest;
    EXPECT_GE(principal_sizes(*size_around(placed, place, 0.4)).l_t, bound * (1 - 1e-12));
  }
}

TEST(TangentFrame, HasTheFrameOfTheFirstForm) {
  const test::PlanePatch skew(Vec3::Zero(), {2, 0, 0}, {1, 3, 0});
  const Jet jet = skew.evaluate({0.5, 0.5}, Order::First);
  const TangentFrame place = tangent_frame(jet);
  const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
  EXPECT_NEAR(place.first.dot(jet.dv), form.l21, 1e-15);
  EXPECT_NEAR(place.second.dot(jet.dv), form.l22, 1e-15);
}

TEST(TangentFrame, IsOrthonormalAtAPole) {
  Jet jet;
  jet.point = jet.du = Vec3::Zero();
  jet.dv = {0, 0, 2};
  const TangentFrame place = tangent_frame(jet);
  EXPECT_NEAR(place.first.z(), 1, 1e-15);
  EXPECT_NEAR(place.first.dot(place.second), 0, 1e-15);
  EXPECT_NEAR(place.second.norm(), 1, 1e-15);
  jet.dv = Vec3::Zero();
  EXPECT_EQ(tangent_frame(jet).first.cross(tangent_frame(jet).second), Vec3::UnitZ());
}

}  // namespace
}  // namespace surfmesh
