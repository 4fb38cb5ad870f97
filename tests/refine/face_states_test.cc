// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/face_states.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "surfmesh/refine/fan.hh"

namespace surfmesh {
namespace {

using testing::empty_square;
using testing::faces_of;
using testing::isotropic_field;

TEST(FaceStates, PredictUnitTrianglesForTheMetricArea) {
  const auto delaunay = empty_square(isotropic_field(0.1));
  const FaceStates states(*delaunay, testing::kAcceptedSize);
  EXPECT_NEAR(states.predicted_count(), 100 / kUnitTriangleArea, 1e-3);
}

TEST(FaceStates, AcceptSmallTriangles) {
  const auto delaunay = empty_square(isotropic_field(10));
  const FaceStates states(*delaunay, testing::kAcceptedSize);
  for (const FaceHandle fh : faces_of(*delaunay)) EXPECT_TRUE(states[fh].is_accepted);
  const FaceStates strict(*delaunay, 1e-6);
  for (const FaceHandle fh : faces_of(*delaunay)) EXPECT_FALSE(strict[fh].is_accepted);
}

/// Two ways to measure agree.
TEST(FaceStates, MeasureAFanAsItsTriangles) {
  const auto field = testing::four_point_field();
  const auto delaunay = empty_square(field);
  FaceStates states(*delaunay, testing::kAcceptedSize);
  states.grow();
  const Uv p{0.4, 0.3};
  const TriangleMetricRule rule{delaunay->uv_handle(), delaunay->metric_handle()};
  const VertexHandle vh = delaunay->insert(p, FaceHandle(0), rule);
  delaunay->metric(vh) = field(p);
  Fan fan;
  collect_fan(*delaunay, vh, fan);
  states.measure_fan(vh, fan);
  const FaceStates fresh(*delaunay, testing::kAcceptedSize);
  constexpr double rounding = 1e-6;  // of float
  EXPECT_NEAR(states.predicted_count(), fresh.predicted_count(),
              rounding * fresh.predicted_count());
  for (const FaceHandle fh : faces_of(*delaunay)) {
    const double radius = double(fresh[fh].squared_radius);
    EXPECT_NEAR(double(states[fh].squared_radius), radius, rounding * radius);
  }
}

TEST(FaceStates, StampTrianglesThatAreMeasuredAnew) {
  const auto field = isotropic_field(0.1);
  const auto delaunay = empty_square(field);
  FaceStates states(*delaunay, testing::kAcceptedSize);
  states.grow();
  const TriangleMetricRule rule{delaunay->uv_handle(), delaunay->metric_handle()};
  const VertexHandle vh = delaunay->insert({0.4, 0.3}, FaceHandle(0), rule);
  delaunay->metric(vh) = field({0.4, 0.3});
  std::vector<std::uint32_t> before;
  for (const FaceHandle fh : faces_of(*delaunay)) before.push_back(states[fh].stamp);
  Fan fan;
  collect_fan(*delaunay, vh, fan);
  states.measure_fan(vh, fan);
  for (const FaceHandle fh : delaunay->mesh().vf_range(vh)) {
    EXPECT_NE(states[fh].stamp, before[index(fh)]);
  }
}

}  // namespace
}  // namespace surfmesh
