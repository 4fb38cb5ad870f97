// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/interpolate.hh"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::expect_near;

const std::array<SizeTensor, 3> kSizes = {size_tensor(1, 0.5, 0.2), size_tensor(2, 0.1, 1.2),
                                          isotropic(0.7)};

SizeTensor at(double d0, double d1, double d2) {
  return interpolate(kSizes, std::array<double, 3>{d0, d1, d2});
}

TEST(Interpolate, OnANodeGivesThatNodeExactly) {
  EXPECT_EQ(at(0, 1, 2), kSizes[0]);
  EXPECT_EQ(at(1, 2, 0), kSizes[2]);
}

TEST(Interpolate, OnTwoNodesGivesTheFirst) { EXPECT_EQ(at(1, 0, 0), kSizes[1]); }

TEST(Interpolate, BetweenTwoNodesGivesTheirMean) {
  const SizeTensor h = interpolate(std::array{isotropic(1), isotropic(3)}, std::array{5.0, 5.0});
  expect_near(h, isotropic(2), 1e-15);
}

TEST(Interpolate, WeighsByTheInverseSquareOfTheDistance) {
  // Distances 1 and 2: weights 4/5 and 1/5.
  const SizeTensor h = interpolate(std::array{isotropic(1), isotropic(2)}, std::array{1.0, 4.0});
  expect_near(h, isotropic(1.2), 1e-15);
}

TEST(Interpolate, OfEqualTensorsIsThatTensor) {
  const std::array<SizeTensor, 3> equal = {kSizes[1], kSizes[1], kSizes[1]};
  expect_near(interpolate(equal, std::array{0.3, 5.0, 70.0}), kSizes[1], 1e-15);
}

TEST(Interpolate, DoesNotDependOnTheUnitOfDistance) {
  expect_near(at(1e-30, 4e-30, 9e-30), at(1, 4, 9), 1e-15);
  expect_near(at(1e300, 4e300, 9e300), at(1, 4, 9), 1e-15);
}

TEST(Interpolate, IsContinuousAtANode) {
  expect_near(at(1e-310, 1, 2), kSizes[0], 1e-15);
  expect_near(at(1e-16, 1, 2), kSizes[0], 1e-14);
}

TEST(Interpolate, OfThreeNodesEqualsThatOfAnyNumber) {
  for (const double d : {0.0, 1e-200, 1e-9, 0.3, 1.0, 1e9, 1e200}) {
    const std::array<double, 3> distances = {1, d, 2};
    const SizeTensor any = interpolate(std::span(kSizes), std::span(distances));
    expect_near(interpolate(kSizes, distances), any, 1e-14);
  }
}

TEST(Interpolate, OfThreeEqualTensorsIsThatTensorExactly) {
  const std::array<SizeTensor, 3> equal = {kSizes[1], kSizes[1], kSizes[1]};
  for (const double d : {1e-9, 0.3, 70.0}) {
    EXPECT_EQ(interpolate(equal, std::array{d, 5.0, 1.7}), kSizes[1]);
  }
}

TEST(Interpolate, OfOneNodeIsThatNode) {
  EXPECT_EQ(interpolate(std::span(kSizes).first(1), std::array{3.0}), kSizes[0]);
}

TEST(InterpolateLinearly, TakesThePointOnTheRimForOneOutside) {
  const std::array<Uv, 3> corners = {Uv{0, 0}, {1, 0}, {0, 1}};
  expect_near(interpolate_linearly(kSizes, corners, {0.25, -3}),
              interpolate_linearly(kSizes, corners, {0.25 / 4, 0}), 1e-14);
  EXPECT_EQ(interpolate_linearly(kSizes, corners, {-1, -2}), kSizes[0]);
}

TEST(InterpolateLinearly, OfATriangleWithoutAreaIsItsFirstCorner) {
  EXPECT_EQ(interpolate_linearly(kSizes, {Uv{1, 1}, {1, 1}, {1, 1}}, {1, 1}), kSizes[0]);
}

}  // namespace
}  // namespace surfmesh
