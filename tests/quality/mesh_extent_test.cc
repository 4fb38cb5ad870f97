// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/mesh_extent.hh"

#include <gtest/gtest.h>

#include <vector>

namespace surfmesh {
namespace {

/// The box [0,2] × [0,3] × [0,4] at some point, its faces to the outside; and an unused vertex.
MeshArrays box_at(const Vec3& origin) {
  MeshArrays set;
  for (const double z : {0.0, 4.0}) {
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 3.0}, {0.0, 3.0}}) {
      set.points.push_back(origin + Vec3(x, y, z));
    }
  }
  set.points.push_back(origin + Vec3(9, 9, 9));
  for (const std::vector<int>& face : std::vector<std::vector<int>>{{0, 3, 2, 1},
                                                                    {4, 5, 6},
                                                                    {4, 6, 7},
                                                                    {0, 1, 5, 4},
                                                                    {1, 2, 6, 5},
                                                                    {2, 3, 7, 6},
                                                                    {3, 0, 4, 7}}) {
    set.faces.add(face);
  }
  return set;
}

TEST(MeasureExtent, TellsAreaVolumeAndBox) {
  const MeshExtent extent = measure_extent(box_at({1, 1, 1}));
  EXPECT_DOUBLE_EQ(extent.area, 52);
  EXPECT_DOUBLE_EQ(extent.volume, 24);
  EXPECT_EQ(extent.box.min(), Vec3(1, 1, 1));
  EXPECT_EQ(extent.box.max(), Vec3(3, 4, 5));
}

TEST(MeasureExtent, IsAsExactFarFromTheOrigin) {
  EXPECT_DOUBLE_EQ(measure_extent(box_at({1e8, -1e8, 1e8})).volume, 24);
}

TEST(MeasureExtent, HasANegativeVolumeInsideOut) {
  MeshArrays set = box_at({0, 0, 0});
  for (Vec3& point : set.points) point.x() = -point.x();
  EXPECT_DOUBLE_EQ(measure_extent(set).volume, -24);
}

TEST(MeasureExtent, IsNoneWithoutFaces) {
  const MeshExtent extent = measure_extent(MeshArrays());
  EXPECT_EQ(extent.area, 0);
  EXPECT_EQ(extent.volume, 0);
  EXPECT_TRUE(extent.box.isEmpty());
}

}  // namespace
}  // namespace surfmesh
