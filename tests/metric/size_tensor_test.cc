// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/size_tensor.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::random_sizes;

TEST(SizeTensor, OfAngleZeroIsDiagonal) {
  EXPECT_EQ(size_tensor(3, 0.5, 0), (SizeTensor{3, 0, 0.5}));
}

TEST(SizeTensor, IsTheSameAfterHalfATurn) {
  expect_near(size_tensor(3, 0.5, 0.4), size_tensor(3, 0.5, 0.4 + std::numbers::pi), 1e-15);
}

TEST(SizeTensor, ExchangesItsLengthsByAQuarterTurn) {
  expect_near(size_tensor(3, 0.5, 0.4), size_tensor(0.5, 3, 0.4 + std::numbers::pi / 2), 1e-15);
}

TEST(SizeTensor, TurnsWithItsAngle) {
  expect_near(testing::rotated(size_tensor(3, 0.5, 0.4), 0.8), size_tensor(3, 0.5, 1.2), 1e-15);
}

TEST(PrincipalSizes, AreThoseTheTensorWasMadeOf) {
  for (const double aspect : {1.001, 2.0, 1e3, 1e6}) {
    for (const double angle : {-1.5, -0.3, 0.0, 0.8, 1.57}) {
      const PrincipalSizes p = principal_sizes(size_tensor(2, 2 / aspect, angle));
      EXPECT_NEAR(p.l_s, 2, 1e-14);
      EXPECT_NEAR(p.l_t, 2 / aspect, 1e-15 * aspect * p.l_t);
      EXPECT_NEAR(p.angle, angle, 1e-12);
    }
  }
}

TEST(PrincipalSizes, GiveTheLargerLengthFirst) {
  const PrincipalSizes p = principal_sizes(size_tensor(0.5, 3, 0.25));
  EXPECT_NEAR(p.l_s, 3, 1e-15);
  EXPECT_NEAR(p.l_t, 0.5, 1e-15);
  EXPECT_NEAR(p.angle, 0.25 - std::numbers::pi / 2, 1e-15);
}

TEST(PrincipalSizes, OfAnIsotropicTensorAreEqualWithAngleZero) {
  const PrincipalSizes p = principal_sizes(isotropic(0.3));
  EXPECT_EQ(p.l_s, 0.3);
  EXPECT_EQ(p.l_t, 0.3);
  EXPECT_EQ(p.angle, 0);
}

TEST(PrincipalSizes, OfADiagonalTensorAreExactAtAnyAspect) {
  const PrincipalSizes p = principal_sizes({1e-9, 0, 1e6});
  EXPECT_EQ(p.l_s, 1e6);
  EXPECT_DOUBLE_EQ(p.l_t, 1e-9);
}

TEST(Scaled, MultipliesBothLengths) {
  expect_near(scaled(size_tensor(3, 0.5, 0.4), 2), size_tensor(6, 1, 0.4), 1e-15);
}

TEST(ClampSizes, BringsBothLengthsIntoTheInterval) {
  expect_near(clamp_sizes(size_tensor(3, 0.5, 0.4), 0.8, 2), size_tensor(2, 0.8, 0.4), 1e-15);
  expect_near(clamp_sizes(size_tensor(0.5, 3, 0.4), 0.8, 2), size_tensor(0.8, 2, 0.4), 1e-15);
}

TEST(ClampSizes, LeavesATensorInsideUntouched) {
  for (const SizeTensor& h : random_sizes(100, 100)) EXPECT_EQ(clamp_sizes(h, 0.01, 1000), h);
}

TEST(ClampSizes, ToOneLengthIsIsotropic) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    EXPECT_EQ(clamp_sizes(h, 1000, 1000), isotropic(1000));
    EXPECT_EQ(clamp_sizes(h, 0.01, 0.01), isotropic(0.01));
  }
}

TEST(ClampSizes, ChangesNothingTheSecondTime) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    const SizeTensor once = clamp_sizes(h, 0.3, 2);
    expect_near(clamp_sizes(once, 0.3, 2), once, 1e-15);
  }
}

TEST(LimitStretch, ShortensTheLargerLength) {
  expect_near(limit_stretch(size_tensor(3, 0.5, 0.4), 2), size_tensor(1, 0.5, 0.4), 1e-15);
  expect_near(limit_stretch(size_tensor(0.5, 3, 0.4), 2), size_tensor(0.5, 1, 0.4), 1e-15);
}

TEST(LimitStretch, LeavesASmallerRatioUntouched) {
  const SizeTensor h = size_tensor(3, 0.5, 0.4);
  EXPECT_EQ(limit_stretch(h, 6.1), h);
}

TEST(LimitStretch, ByOneIsIsotropic) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    const double l_t = principal_sizes(h).l_t;
    expect_near(limit_stretch(h, 1), isotropic(l_t), 1e-15);
  }
}

TEST(SizeFromMetric, UndoesMetricFromSize) {
  const FirstFormFactor p = first_form_factor({3, 0, 4}, {1, 2, -1});
  for (const double aspect : {1.0, 10.0, 1e3, 1e5}) {
    for (const SizeTensor& h : random_sizes(50, aspect)) {
      expect_near(size_from_metric(p, metric_from_size(p, h)), h, 1e-14 * aspect * aspect + 1e-14);
    }
  }
}

TEST(SizeFromMetric, IsUndoneByMetricFromSize) {
  const FirstFormFactor p = first_form_factor({3, 0, 4}, {1, 2, -1});
  const Metric m{4000, -700, 900};
  expect_near(metric_from_size(p, size_from_metric(p, m)), m, 1e-13);
}

TEST(SizeFromMetric, DoesNotDependOnTheScaleOfTheParameters) {
  const Vec3 du(3, 0, 4), dv(1, 2, -1);
  const FirstFormFactor p = first_form_factor(du / 1e6, dv / 1e-3);
  for (const SizeTensor& h : random_sizes(50, 10)) {
    expect_near(size_from_metric(p, metric_from_size(p, h)), h, 1e-11);
  }
}

}  // namespace
}  // namespace surfmesh
