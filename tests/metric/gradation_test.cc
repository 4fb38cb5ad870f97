// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/gradation.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::random_sizes;

TEST(Graded, LimitsAnIsotropicSizeToItsGrowth) {
  // Size 0.1 at i, distance 0.3 = 3 units: at most 0.1 (1 + 3 ln 1.5).
  const SizeTensor h = graded(isotropic(5), isotropic(0.1), 3, 1.5);
  expect_near(h, isotropic(0.1 * (1 + 3 * std::log(1.5))), 1e-15);
}

TEST(Graded, LeavesASizeWithinTheLimitBitByBit) {
  const SizeTensor h = size_tensor(0.15, 0.12, 0.3);
  EXPECT_EQ(graded(h, isotropic(0.1), 3, 1.5), h);
}

TEST(Graded, ChangesNothingTheSecondTime) {
  const auto a = random_sizes(200, 1e4, 1), b = random_sizes(200, 1e4, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const SizeTensor once = graded(a[i], b[i], 2, 1.5);
    EXPECT_EQ(graded(once, b[i], 2, 1.5), once);
  }
}

TEST(Graded, ObeysTheRuleForMetricsInAllDirections) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  const double growth = 1 + 2 * std::log(1.3);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Metric at_j = testing::metric_of(graded(a[i], b[i], 2, 1.3));
    const Metric at_i = testing::metric_of(b[i]);
    for (const Uv d : testing::directions()) {
      EXPECT_GE(squared_length(at_j, d), squared_length(at_i, d) / (growth * growth) * (1 - 1e-9));
    }
  }
}

TEST(Graded, ByZeroIsOff) { EXPECT_EQ(graded(isotropic(5), isotropic(0.1), 3, 0), isotropic(5)); }

TEST(Graded, ByOneAllowsNoGrowth) {
  EXPECT_EQ(graded(isotropic(5), isotropic(0.1), 3, 1), isotropic(0.1));
}

TEST(Graded, GrowsLinearlyWhateverTheSpacingOfNodes) {
  // Many short edges in a row allow the same size as one long edge.
  const double slope = std::log(1.5);
  SizeTensor h = isotropic(1);
  for (int i = 0; i < 1000; ++i) h = graded(isotropic(100), h, 0.01 / h.h11, 1.5);
  EXPECT_NEAR(h.h11, 1 + 10 * slope, 1e-10);
}

}  // namespace
}  // namespace surfmesh
