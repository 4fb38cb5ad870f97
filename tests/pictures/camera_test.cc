// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/camera.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

TEST(PlaneView, FitsARectangleIntoItsFrame) {
  const PlaneView view({Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1)}, {{10, 20}, 100, 100});
  EXPECT_EQ(view.scale(), 50);
  EXPECT_EQ(view(-1, 0).x, 10);
  EXPECT_EQ(view(1, 0).x, 110);
  EXPECT_EQ(view(0, 0).y, 95);  // in the middle, upwards
  EXPECT_EQ(view(0, 1).y, 45);
}

TEST(CameraAxes, LookFromTheAzimuthAndFromAbove) {
  const CameraAxes front({.azimuth = -90, .elevation = 0});
  EXPECT_TRUE(front.towards.isApprox(Vec3(0, -1, 0)));
  EXPECT_TRUE(front.right.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(front.up.isApprox(Vec3(0, 0, 1)));
  const CameraAxes top({.azimuth = -90, .elevation = 90});
  EXPECT_TRUE(top.towards.isApprox(Vec3(0, 0, 1)));
  EXPECT_TRUE(top.up.isApprox(Vec3(0, 1, 0)));
}

TEST(CameraAxes, HaveAnyAxisUpwards) {
  EXPECT_TRUE(CameraAxes({.elevation = 0, .up = Axis::X}).up.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(CameraAxes({.elevation = 0, .up = Axis::Y}).up.isApprox(Vec3(0, 1, 0)));
  for (const Axis up : {Axis::X, Axis::Y, Axis::Z}) {
    const CameraAxes axes({.azimuth = 20, .elevation = 40, .up = up});
    EXPECT_TRUE(axes.right.cross(axes.up).isApprox(axes.towards)) << "as seen, not in a mirror";
  }
}

}  // namespace
}  // namespace surfmesh
