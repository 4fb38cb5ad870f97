// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/tensor.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::expect_near;

const Vec3 kDu(3, 0, 4);
const Vec3 kDv(1, 2, -1);

TEST(SquaredLength, IsTheInnerProductOfAStepWithItself) {
  const Metric m{4, 1, 2};
  const Uv e{0.5, -2};
  EXPECT_DOUBLE_EQ(squared_length(m, e), 4 * 0.25 - 2 * 1.0 + 2 * 4.0);
  EXPECT_DOUBLE_EQ(inner_product(m, e, e), squared_length(m, e));
}

TEST(InnerProduct, IsSymmetricAndObeysThePolarisationIdentity) {
  const Metric m{4, 1, 2};
  const Uv a{1, 3}, b{-2, 0.25};
  EXPECT_DOUBLE_EQ(inner_product(m, a, b), inner_product(m, b, a));
  EXPECT_DOUBLE_EQ(4 * inner_product(m, a, b), squared_length(m, a + b) - squared_length(m, a - b));
}

TEST(Determinant, IsTheProductOfThePrincipalSizes) {
  EXPECT_NEAR(determinant(size_tensor(3, 0.5, 0.7)), 1.5, 1e-15);
  EXPECT_DOUBLE_EQ(determinant(Metric{4, 1, 2}), 7);
}

TEST(MetricMean, OfEqualMetricsIsThatMetric) {
  const Metric m{4, 1, 2};
  EXPECT_EQ(mean(m, m), m);
  expect_near(mean(m, m, m), m, 1e-15);
}

TEST(MetricMean, AveragesTheEntries) {
  EXPECT_EQ(mean(Metric{1, 0, 1}, Metric{3, 1, 5}), (Metric{2, 0.5, 3}));
  expect_near(mean(Metric{1, 0, 1}, Metric{3, 1, 5}, {5, 2, 3}), {3, 1, 3}, 1e-15);
}

TEST(FirstFormFactor, MultipliedWithItsTransposeIsTheFirstFundamentalForm) {
  const FirstFormFactor p = first_form_factor(kDu, kDv);
  EXPECT_NEAR(p.l11 * p.l11, kDu.dot(kDu), 1e-13);
  EXPECT_NEAR(p.l11 * p.l21, kDu.dot(kDv), 1e-13);
  EXPECT_NEAR(p.l21 * p.l21 + p.l22 * p.l22, kDv.dot(kDv), 1e-13);
}

TEST(FirstFormFactor, KeepsTheSmallAreaOfNearlyParallelDerivatives) {
  const FirstFormFactor p = first_form_factor({1, 0, 0}, {1, 1e-9, 0});
  EXPECT_NEAR(p.l22, 1e-9, 1e-24);
}

TEST(FirstFormFactor, TakesTheOtherAxisWhereTheFirstDerivativeVanishes) {
  const FirstFormFactor p = first_form_factor(Vec3::Zero(), kDv);
  EXPECT_EQ(p.l11, 0);
  EXPECT_EQ(p.l21, kDv.norm());
  EXPECT_EQ(p.l22, 0);
}

TEST(MetricFromSize, GivesAWantedStepTheLengthOne) {
  const FirstFormFactor p = first_form_factor(kDu, kDv);
  const SizeTensor h = size_tensor(0.5, 0.02, 0.3);
  const Metric m = metric_from_size(p, h);
  for (const Uv t : testing::directions()) {
    // The parameter step whose tangent step M_pᵀ e has the wanted length in the direction t.
    const double length = testing::wanted_length(h, t);
    const double v = length * t.v / p.l22;
    const double u = (length * t.u - p.l21 * v) / p.l11;
    EXPECT_NEAR(squared_length(m, {u, v}), 1, 1e-12);
  }
}

TEST(MetricFromSize, OfAUnitSizeIsTheFirstFundamentalForm) {
  const Metric m = metric_from_size(first_form_factor(kDu, kDv), isotropic(1));
  expect_near(m, {kDu.dot(kDu), kDu.dot(kDv), kDv.dot(kDv)}, 1e-14);
}

TEST(MetricFromSize, DoesNotDependOnTheScaleOfTheParameters) {
  const SizeTensor h = size_tensor(0.5, 0.02, 0.3);
  const Metric m = metric_from_size(first_form_factor(kDu, kDv), h);
  const Metric scaled = metric_from_size(first_form_factor(kDu / 1e6, kDv / 1e-3), h);
  expect_near(scaled, testing::with_scaled_parameters(m, 1e6, 1e-3), 1e-13);
}

TEST(MetricFromSize, GivesLengthsThatDoNotDependOnTheFrame) {
  // Exchanging the parameters makes the old second axis the first one, and the angle counts from
  // there the other way round.
  const Vec3 du(2, 0, 0), dv(0, 3, 0);
  const double angle = 0.3;
  const Metric m = metric_from_size(first_form_factor(du, dv), size_tensor(0.5, 0.02, angle));
  const Metric n = metric_from_size(first_form_factor(dv, du),
                                    size_tensor(0.5, 0.02, std::numbers::pi / 2 - angle));
  expect_near({n.m22, n.m12, n.m11}, m, 1e-13);
}

TEST(EdgeLength, IsSymmetric) {
  for (const double l0 : {0.1, 1.0, 1.0005, 7.0}) {
    for (const double l1 : {0.2, 1.0, 1.001, 50.0}) {
      EXPECT_DOUBLE_EQ(edge_length(l0, l1), edge_length(l1, l0));
    }
  }
}

TEST(EdgeLength, LiesBetweenItsArguments) {
  for (double ratio = 1; ratio < 1e6; ratio *= 1.01) {
    EXPECT_GE(edge_length(2, 2 * ratio), 2 * (1 - 1e-14));
    EXPECT_LE(edge_length(2, 2 * ratio), 2 * ratio * (1 + 1e-14));
  }
}

TEST(EdgeLength, IsContinuousWhereItsSeriesEnds) {
  // The relative half difference is x at l1 = (1 − x) / (1 + x).
  const double x = std::sqrt(kNearlyEqualLengths);
  for (const double factor : {0.99, 1 - 1e-9, 1 + 1e-9, 1.01}) {
    const double l1 = (1 - factor * x) / (1 + factor * x);
    const long double exact =
        (1 - static_cast<long double>(l1)) / -std::log(static_cast<long double>(l1));
    EXPECT_NEAR(edge_length(1, l1), static_cast<double>(exact), 1e-12);
  }
}

TEST(EdgeLength, IsExactForASizeThatChangesGeometrically) {
  // Size a^s along a unit step: length ∫ a^-s ds = (1 − 1/a) / ln a.
  for (const double a : {1.0001, 1.5, 4.0, 100.0}) {
    EXPECT_NEAR(edge_length(1, 1 / a), (1 - 1 / a) / std::log(a), 1e-12);
  }
}

TEST(EdgeLength, OfEqualLengthsIsThatLengthAndOfNoLengthIsZero) {
  EXPECT_EQ(edge_length(0.7, 0.7), 0.7);
  EXPECT_EQ(edge_length(0, 0), 0);
  EXPECT_EQ(edge_length(0, 2), 0);
}

TEST(EdgeLength, DoesNotHideALengthThatIsUnset) {
  EXPECT_TRUE(std::isnan(edge_length(kUnset, 1)));
  EXPECT_TRUE(std::isnan(edge_length(1, kUnset)));
}

}  // namespace
}  // namespace surfmesh
