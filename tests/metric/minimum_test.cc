// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/minimum.hh"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::directions;
using testing::expect_near;
using testing::metric_of;
using testing::random_sizes;
using testing::wanted_length;

/// The slow obvious way: the generalised eigenvectors of both metrics.
Metric reduced_simultaneously(const Metric& a, const Metric& b) {
  const Eigen::Matrix2d ma{{a.m11, a.m12}, {a.m12, a.m22}}, mb{{b.m11, b.m12}, {b.m12, b.m22}};
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(mb, ma);
  const Eigen::Matrix2d inverse = solver.eigenvectors().inverse();
  const Eigen::Vector2d greater = solver.eigenvalues().cwiseMax(1.0);
  const Eigen::Matrix2d m = inverse.transpose() * greater.asDiagonal() * inverse;
  return {m(0, 0), m(0, 1), m(1, 1)};
}

TEST(MetricMinimum, IsNoLongerThanEitherInAnyDirection) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Metric ma = metric_of(a[i]), mb = metric_of(b[i]), m = minimum(ma, mb);
    for (const Uv d : directions()) {
      EXPECT_LE(wanted_length(m, d), wanted_length(ma, d) * (1 + 1e-10));
      EXPECT_LE(wanted_length(m, d), wanted_length(mb, d) * (1 + 1e-10));
    }
  }
}

TEST(MetricMinimum, IsTheSimultaneousReduction) {
  const auto a = random_sizes(100, 30, 1), b = random_sizes(100, 30, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Metric ma = metric_of(a[i]), mb = metric_of(b[i]);
    expect_near(minimum(ma, mb), reduced_simultaneously(ma, mb), 1e-10);
  }
}

TEST(MetricMinimum, IsExactlyCommutative) {
  const auto a = random_sizes(100, 1e6, 1), b = random_sizes(100, 1e6, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(minimum(metric_of(a[i]), metric_of(b[i])), minimum(metric_of(b[i]), metric_of(a[i])));
  }
}

TEST(MetricMinimum, OfEqualMetricsIsThatMetric) {
  for (const SizeTensor& h : random_sizes(100, 1e6)) {
    EXPECT_EQ(minimum(metric_of(h), metric_of(h)), metric_of(h));
  }
}

TEST(MetricMinimum, OfNestedMetricsIsTheShorterOne) {
  const Metric large = metric_of(size_tensor(3, 2, 0.4)), small = metric_of(size_tensor(1, 0.5, 1));
  EXPECT_EQ(minimum(large, small), small);
}

TEST(MetricMinimum, OfDiagonalMetricsIsTheMaximumOfTheEntries) {
  expect_near(minimum(Metric{4, 0, 1}, Metric{1, 0, 9}), Metric{4, 0, 9}, 1e-15);
}

TEST(MetricMinimum, TakesAMetricThatIsSingular) {
  expect_near(minimum(Metric{0, 0, 9}, Metric{4, 0, 1}), Metric{4, 0, 9}, 1e-15);
  EXPECT_EQ(minimum(Metric{0, 0, 9}, Metric{0, 0, 4}), (Metric{0, 0, 9}));
  EXPECT_EQ(minimum(Metric{4, 0, 0}, Metric{9, 0, 0}), (Metric{9, 0, 0}));
}

TEST(MetricMinimum, DoesNotDependOnTheScaleOfTheParameters) {
  const auto a = random_sizes(100, 10, 1), b = random_sizes(100, 10, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Metric ma = metric_of(a[i]), mb = metric_of(b[i]);
    const auto scale = [](const Metric& m) {
      return testing::with_scaled_parameters(m, 1e6, 1e-3);
    };
    expect_near(minimum(scale(ma), scale(mb)), scale(minimum(ma, mb)), 1e-12);
  }
}

TEST(SizeMinimum, IsNoLongerThanEitherInAnyDirection) {
  for (const double aspect : {1.0, 10.0, 1e6}) {
    const auto a = random_sizes(200, aspect, 1), b = random_sizes(200, aspect, 2);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const SizeTensor m = minimum(a[i], b[i]);
      for (const Uv d : directions()) {
        EXPECT_LE(wanted_length(m, d), wanted_length(a[i], d) * (1 + 1e-9));
        EXPECT_LE(wanted_length(m, d), wanted_length(b[i], d) * (1 + 1e-9));
      }
    }
  }
}

TEST(SizeMinimum, IsThatOfTheMetrics) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Metric m = minimum(metric_of(a[i]), metric_of(b[i]));
    expect_near(minimum(a[i], b[i]), size_from_metric({1, 0, 1}, m), 1e-9);
  }
}

TEST(SizeMinimum, IsExactlyCommutative) {
  const auto a = random_sizes(100, 1e6, 1), b = random_sizes(100, 1e6, 2);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(minimum(a[i], b[i]), minimum(b[i], a[i]));
}

TEST(SizeMinimum, OfEqualTensorsIsThatTensor) {
  for (const SizeTensor& h : random_sizes(100, 1e6)) EXPECT_EQ(minimum(h, h), h);
}

TEST(SizeMinimum, WithOneOfItsArgumentsAgainStaysBitByBit) {
  const auto a = random_sizes(200, 1e4, 1), b = random_sizes(200, 1e4, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const SizeTensor m = minimum(a[i], b[i]);
    EXPECT_EQ(minimum(m, b[i]), m);
    EXPECT_EQ(minimum(a[i], m), m);
  }
}

TEST(SizeMinimum, OfNestedTensorsIsTheShorterOne) {
  const SizeTensor large = size_tensor(3, 2, 0.4), small = size_tensor(1, 0.5, 1);
  EXPECT_EQ(minimum(large, small), small);
  EXPECT_EQ(minimum(small, large), small);
}

TEST(SizeMinimum, KeepsTheLengthsOfCrossedTensorsAtAspectAMillion) {
  for (const double angle : {0.0, 0.3, 1.2}) {
    const SizeTensor a = size_tensor(1, 1e-6, angle);
    const SizeTensor b = size_tensor(2e-6, 1, angle);
    const PrincipalSizes p = principal_sizes(minimum(a, b));
    EXPECT_NEAR(p.l_s, 2e-6, 1e-15);
    EXPECT_NEAR(p.l_t, 1e-6, 1e-15);
  }
}

TEST(SizeMinimum, KeepsTheLargerLengthAtAspectAMillion) {
  // Isotropic 0.5 cuts the length 1, and the layer's thickness stays.
  for (const double angle : {0.0, 0.3, 1.2}) {
    const PrincipalSizes p = principal_sizes(minimum(size_tensor(1, 1e-6, angle), isotropic(0.5)));
    EXPECT_NEAR(p.l_s, 0.5, 1e-9);
    EXPECT_NEAR(p.l_t, 1e-6, 1e-15);
  }
}

TEST(SizeMinimum, TakesATensorThatAsksForNothingInOneDirection) {
  const SizeTensor m = minimum(size_tensor(1e12, 0.1, 0), isotropic(2));
  EXPECT_NEAR(m.h11, 2, 1e-12);
  EXPECT_NEAR(m.h22, 0.1, 1e-12);
}

TEST(SizeMinimum, TurnsWithItsArguments) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const SizeTensor turned = minimum(testing::rotated(a[i], 0.7), testing::rotated(b[i], 0.7));
    expect_near(turned, testing::rotated(minimum(a[i], b[i]), 0.7), 1e-10);
  }
}

TEST(SizeMinimum, GrowsWithTheUnit) {
  const auto a = random_sizes(100, 100, 1), b = random_sizes(100, 100, 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    expect_near(minimum(scaled(a[i], 1e6), scaled(b[i], 1e6)), scaled(minimum(a[i], b[i]), 1e6),
                1e-10);
  }
}

}  // namespace
}  // namespace surfmesh
