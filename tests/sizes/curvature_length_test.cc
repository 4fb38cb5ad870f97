// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/curvature_length.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hh"

namespace surfmesh {
namespace {

Sizing with_sag(double sag, std::optional<double> curvature = {}) {
  Sizing sizing;
  sizing.sag = Length::units(sag);
  sizing.curvature = curvature;
  return sizing;
}

TEST(CurvatureLength, IsTheFactorTimesTheRadius) {
  EXPECT_DOUBLE_EQ(CurvatureLength(resolve({.curvature = 0.2}, 1)).of_surface(-0.5), 0.4);
  EXPECT_DOUBLE_EQ(CurvatureLength(resolve({}, 1)).of_curve(1), 0.25);
}

TEST(CurvatureLength, KeepsTheSagOfASegmentBelowTheOneAskedFor) {
  for (const double k : {0.1, 3.0, -20.0}) {
    const double h = CurvatureLength(resolve(with_sag(0.01), 1)).of_curve(k);
    EXPECT_LT(h * h * std::abs(k) / 8, 0.01) << k;
    EXPECT_GT(h * h * std::abs(k) / 8, 0.008) << k;
  }
}

TEST(CurvatureLength, OfTheSagTurnsTheFactorOffThatIsNotGiven) {
  const CurvatureLength sag_alone(resolve(with_sag(0.01), 1)),
      both(resolve(with_sag(0.01, 0.001), 1));
  EXPECT_GT(sag_alone.of_surface(1), 0.2);
  EXPECT_DOUBLE_EQ(both.of_surface(1), 0.001);
}

TEST(CurvatureLength, TakesAShareOfTheDiagonal) {
  Sizing sizing;
  sizing.sag = Length::share(0.001);
  EXPECT_DOUBLE_EQ(CurvatureLength(resolve(sizing, 10)).of_surface(2),
                   CurvatureLength(resolve(with_sag(0.01), 1)).of_surface(2));
}

TEST(CurvatureLength, IsInfiniteWhereNothingBends) {
  EXPECT_TRUE(std::isinf(CurvatureLength(resolve(with_sag(0.01, 0.2), 1)).of_surface(0)));
  EXPECT_TRUE(CurvatureLength(resolve({.curvature = 0}, 1)).is_off());
}

}  // namespace
}  // namespace surfmesh
