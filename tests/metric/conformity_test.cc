// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/conformity.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::random_sizes;

TEST(EntryConformity, OfEqualTensorsIsZero) {
  for (const SizeTensor& h : random_sizes(100, 1e6)) EXPECT_EQ(entry_conformity(h, h), 0);
}

TEST(EntryConformity, IsTheGreatestEntryOfTheRatio) {
  EXPECT_DOUBLE_EQ(entry_conformity({3, 0, 1}, {2, 0, 1}), 0.5);
  EXPECT_DOUBLE_EQ(entry_conformity({1, 0, 1}, {2, 0, 1}), 0.5);
  // D = (2 −1; −1 2) for H_o = 1 and H_t = (2 1; 1 2) / 3.
  EXPECT_NEAR(entry_conformity({1, 0, 1}, {2. / 3, 1. / 3, 2. / 3}), 1, 1e-15);
}

TEST(EntryConformity, SeesAnEntryAsideOfTheDiagonal) {
  EXPECT_DOUBLE_EQ(entry_conformity({1, 0.25, 1}, {1, 0, 1}), 0.25);
}

TEST(EntryConformity, OfAOneDegreeTurnAtAspectHundredIsOfOrderOne) {
  // With the metrics in place of the size tensors it would be a hundred times that.
  const double degree = std::numbers::pi / 180;
  const double value =
      entry_conformity(size_tensor(100, 1, 0.3 + degree), size_tensor(100, 1, 0.3));
  EXPECT_GT(value, 0.8);
  EXPECT_LT(value, 1.8);
}

TEST(LogConformity, OfEqualTensorsIsZero) {
  for (const SizeTensor& h : random_sizes(100, 1e6)) EXPECT_EQ(log_conformity(h, h), 0);
}

TEST(LogConformity, OfAScaledTensorIsTheLogarithmOfTheFactor) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    for (const double factor : {1 + 1e-9, 2.0, 0.5, 1e5, 1e-5}) {
      const double expected = std::abs(std::log(factor));
      EXPECT_NEAR(log_conformity(scaled(h, factor), h), expected, 1e-11 * expected + 1e-13);
    }
  }
}

TEST(LogConformity, TakesTheGreaterOfBothDirections) {
  EXPECT_DOUBLE_EQ(log_conformity({2, 0, 0.125}, {1, 0, 1}), std::log(8.0));
  EXPECT_DOUBLE_EQ(log_conformity({8, 0, 0.5}, {1, 0, 1}), std::log(8.0));
}

TEST(MetricConformity, IsTheLogarithmOfTheGreatestRatioOfLengths) {
  // Twice the length in one direction, a third in the other.
  EXPECT_DOUBLE_EQ(metric_conformity({1, 0, 1}, {4, 0, 1.0 / 9}), std::log(3.0));
  EXPECT_DOUBLE_EQ(metric_conformity({4, 0, 1.0 / 9}, {1, 0, 1}), std::log(3.0));
  EXPECT_EQ(metric_conformity({2, 1, 3}, {2, 1, 3}), 0);
}

TEST(LogConformity, IsExactlySymmetric) {
  const auto a = random_sizes(100, 1e4, 1), b = random_sizes(100, 1e4, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(log_conformity(a[i], b[i]), log_conformity(b[i], a[i]));
  }
}

TEST(LogConformity, DoesNotDependOnTheFrame) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(log_conformity(testing::rotated(a[i], 0.7), testing::rotated(b[i], 0.7)),
                log_conformity(a[i], b[i]), 1e-11);
  }
}

TEST(LogConformity, IsAccurateForNearlyEqualTensors) {
  const SizeTensor h = size_tensor(1, 0.2, 0.4);
  for (const double eps : {1e-3, 1e-6, 1e-9}) {
    const SizeTensor near = size_tensor(1 + eps, 0.2, 0.4);
    EXPECT_NEAR(log_conformity(near, h), std::log1p(eps), 1e-14);
  }
}

TEST(LogConformity, OfAOneDegreeTurnAtAspectHundredIsNearEightTenths) {
  // Eigenvalues e^±x with 2 cosh x = 2 + sin²(1°) (a − 1)²/a: x = 0.84 at a = 100.
  const double s = std::sin(std::numbers::pi / 180);
  const double expected = std::acosh(1 + 0.5 * s * s * 99 * 99 / 100);
  EXPECT_NEAR(
      log_conformity(size_tensor(100, 1, 0.3 + std::numbers::pi / 180), size_tensor(100, 1, 0.3)),
      expected, 1e-10);
}

}  // namespace
}  // namespace surfmesh
