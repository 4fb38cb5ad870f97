// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/curve.hh"

#include <gtest/gtest.h>

#include <memory>

namespace surfmesh {
namespace {

// A segment on a side left the domain by a rounding: (1 - t) * 1.44774 + t * 1.44774 may be above
// 1.44774.
TEST(SegmentCurve, KeepsACoordinateThatBothEndsHave) {
  const SegmentCurve side({0.80214, 1.44774}, {7.31189, 1.44774});
  for (int i = 0; i <= 1000; ++i) EXPECT_EQ(side.evaluate(i / 1000.0).v, 1.44774);
}

TEST(SegmentCurve, IsExactAtBothEnds) {
  const SegmentCurve segment({0.1, -3.7}, {0.7, 1e9});
  EXPECT_EQ(segment.evaluate(0), (Uv{0.1, -3.7}));
  EXPECT_EQ(segment.evaluate(1), (Uv{0.7, 1e9}));
}

TEST(CurvePart, RunsBetweenTwoPlacesOfTheWhole) {
  const auto whole = std::make_shared<CallableCurve>([](double t) { return Uv{t, t * t}; });
  const CurvePart<Curve> part(whole, 0.3, 0.7);
  EXPECT_EQ(part.evaluate(0), whole->evaluate(0.3));
  EXPECT_EQ(part.evaluate(1), whole->evaluate(0.7));
  EXPECT_DOUBLE_EQ(part.evaluate(0.5).u, 0.5);
}

}  // namespace
}  // namespace surfmesh
