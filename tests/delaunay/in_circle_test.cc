// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/in_circle.hh"

#include <gtest/gtest.h>

#include <array>

namespace surfmesh {
namespace {

TEST(InMetricCircle, IsTheCircleOfTheMetric) {
  // The unit circle of diag(1, 1/4) is the ellipse with half axes 1 and 2.
  const Metric m{1, 0, 0.25};
  const std::array<Uv, 3> triangle = {Uv{1, 0}, Uv{0, 2}, Uv{-1, 0}};
  EXPECT_TRUE(in_metric_circle(triangle, {0, -1.99}, m));
  EXPECT_FALSE(in_metric_circle(triangle, {0, -2.01}, m));
  EXPECT_FALSE(in_metric_circle(triangle, {0.9, 1.2}, m));
}

TEST(InMetricCircle, CountsCocircularPointsAsOutside) {
  const std::array<Uv, 3> triangle = {Uv{0, 0}, Uv{1, 0}, Uv{1, 1}};
  EXPECT_FALSE(in_metric_circle(triangle, {0, 1}, {1, 0, 1}));
}

}  // namespace
}  // namespace surfmesh
