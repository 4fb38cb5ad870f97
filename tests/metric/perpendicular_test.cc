// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/perpendicular.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

TEST(UnitLeftOf, IsAUnitStepToTheLeftAtARightAngleInTheMetric) {
  for (const Metric& m : {Metric{1, 0, 1}, Metric{100, 3, 0.5}, Metric{2, -1, 3}}) {
    for (const Uv edge : {Uv{1, 0}, Uv{-2, 5}, Uv{0.01, -3}}) {
      const Uv left = unit_left_of(edge, std::sqrt(squared_length(m, edge)), m);
      EXPECT_NEAR(squared_length(m, left), 1, 1e-12);
      EXPECT_NEAR(inner_product(m, left, edge), 0, 1e-11);
      EXPECT_GT(cross(edge, left), 0);
    }
  }
}

}  // namespace
}  // namespace surfmesh
