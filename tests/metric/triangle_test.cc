// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/triangle.hh"

#include <gtest/gtest.h>

#include <array>

#include "support/tensors.hh"

namespace surfmesh {
namespace {

using testing::metric_of;
using testing::random_sizes;
using testing::with_scaled_parameters;
using Triangle = std::array<MetricCorner, 3>;

/// The triangle of the plane that H takes to wanted lengths, with the metric of H.
Triangle triangle_in(const SizeTensor& h, const std::array<Uv, 3>& plane) {
  Triangle result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Uv p = plane[k];
    result[k] = {{h.h11 * p.u + h.h12 * p.v, h.h12 * p.u + h.h22 * p.v}, metric_of(h)};
  }
  return result;
}

const std::array<Uv, 3> kUnitTriangle = {{{0, 0}, {1, 0}, {0.5, 0.5 * std::numbers::sqrt3}}};

double radius(const Triangle& t) { return squared_circumradius(t[0], t[1], t[2]); }

TEST(FastEdgeLength, IsExactForOneMetric) {
  for (const double length : {1e-3, 0.7, 1.0, 12.0}) {
    EXPECT_NEAR(fast_edge_length(length * length, length * length), length, 1e-15 * length);
  }
}

TEST(FastEdgeLength, IsWithinOnePercentForRatiosUpToFour) {
  double worst = 0;
  for (double ratio = 1; ratio <= 4; ratio += 0.01) {
    const double exact = edge_length(1, ratio);
    worst = std::max(worst, std::abs(fast_edge_length(1, ratio * ratio) / exact - 1));
  }
  EXPECT_LT(worst, 0.01);
  EXPECT_GT(worst, 1e-4);  // else it is another formula
}

TEST(FastEdgeLength, DoesNotDependOnTheDirection) {
  const Metric ma{4, 1, 2}, mb{9, -2, 5};
  EXPECT_EQ(fast_edge_length({0, 0}, ma, {0.3, 0.2}, mb),
            fast_edge_length({0.3, 0.2}, mb, {0, 0}, ma));
}

TEST(Circumradius, OfTheUnitTriangleOfAMetricIsOneThirdSquared) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    EXPECT_NEAR(radius(triangle_in(h, kUnitTriangle)), 1.0 / 3, 1e-10);
  }
}

TEST(Circumradius, OfARightTriangleIsHalfItsHypotenuse) {
  for (const SizeTensor& h : random_sizes(100, 100)) {
    EXPECT_NEAR(radius(triangle_in(h, {{{0, 0}, {3, 0}, {0, 4}}})), 6.25, 1e-9);
  }
}

TEST(Circumradius, OfNoAreaIsInfinite) {
  const Metric m{1, 0, 1};
  EXPECT_EQ(squared_circumradius({{0, 0}, m}, {{1, 1}, m}, {{2, 2}, m}), INFINITY);
}

TEST(Circumradius, DoesNotDependOnTheOrderOfTheCorners) {
  const Triangle t = {{{{0, 0}, {4, 1, 2}}, {{0.5, 0.1}, {9, 0, 1}}, {{0.2, 0.6}, {1, -0.5, 3}}}};
  EXPECT_NEAR(radius({t[1], t[2], t[0]}), radius(t), 1e-14 * radius(t));
  EXPECT_NEAR(radius({t[1], t[0], t[2]}), radius(t), 1e-14 * radius(t));
}

TEST(Circumradius, DoesNotDependOnTheScaleOfTheParameters) {
  const Triangle t = {{{{0, 0}, {4, 1, 2}}, {{0.5, 0.1}, {9, 0, 1}}, {{0.2, 0.6}, {1, -0.5, 3}}}};
  Triangle scaled = t;
  for (MetricCorner& c : scaled) {
    c = {{1e6 * c.uv.u, 1e-3 * c.uv.v}, with_scaled_parameters(c.metric, 1e6, 1e-3)};
  }
  EXPECT_NEAR(radius(scaled), radius(t), 1e-12 * radius(t));
}

TEST(CornerQuality, DoesNotDependOnTheScaleOfTheParameters) {
  const Triangle t = {{{{0, 0}, {4, 1, 2}}, {{0.5, 0.1}, {9, 0, 1}}, {{0.2, 0.6}, {1, -0.5, 3}}}};
  Triangle scaled = t;
  for (MetricCorner& c : scaled) {
    c = {{1e6 * c.uv.u, 1e-3 * c.uv.v}, with_scaled_parameters(c.metric, 1e6, 1e-3)};
  }
  EXPECT_NEAR(triangle_quality(scaled[0], scaled[1], scaled[2]), triangle_quality(t[0], t[1], t[2]),
              1e-12);
}

TEST(CornerQuality, IsThatOfTheMeanMetric) {
  const Triangle t = {{{{0, 0}, {3, 0, 3}}, {{1, 0}, {2, 0, 2}}, {{0, 1}, {1, 0, 1}}}};
  EXPECT_NEAR(triangle_quality(t[0], t[1], t[2]), 0.5 * std::numbers::sqrt3, 1e-15);
}

TEST(CornerQuality, ChangesSignWithTheOrientationOnly) {
  const Triangle t = {{{{0, 0}, {4, 1, 2}}, {{0.5, 0.1}, {9, 0, 1}}, {{0.2, 0.6}, {1, -0.5, 3}}}};
  const double q = triangle_quality(t[0], t[1], t[2]);
  EXPECT_NEAR(triangle_quality(t[1], t[2], t[0]), q, 1e-15);
  EXPECT_NEAR(triangle_quality(t[1], t[0], t[2]), -q, 1e-15);
}

TEST(CornerQuality, IsAtMostOne) {
  const std::vector<SizeTensor> sizes = random_sizes(300, 1000);
  for (std::size_t i = 0; i + 2 < sizes.size(); i += 3) {
    const MetricCorner a{{0, 0}, metric_of(sizes[i])}, b{{1, 0}, metric_of(sizes[i + 1])},
        c{{0.3, 0.8}, metric_of(sizes[i + 2])};
    EXPECT_LE(triangle_quality(a, b, c), 1);
    EXPECT_GE(triangle_quality(a, b, c), 0);
  }
}

TEST(CornerQuality, OfAMetricWithoutAreaIsZero) {
  EXPECT_EQ(triangle_quality({0, 0}, {1, 0}, {0, 1}, Metric{1, 1, 1 - 1e-16}), 0);
}

}  // namespace
}  // namespace surfmesh
