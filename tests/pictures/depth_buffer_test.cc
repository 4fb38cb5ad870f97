// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/depth_buffer.hh"

#include <gtest/gtest.h>

#include "pictures/scenes.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using testing::scene_of_triangles;

/// Two halves of a square from (2,2) to (8,8), and a triangle before a part of it.
Scene square_with_triangle() {
  return scene_of_triangles({{{{2, 2, 0}, {8, 2, 0}, {8, 8, 0}}},
                             {{{2, 2, 0}, {8, 8, 0}, {2, 8, 0}}},
                             {{{0, 0, 5}, {4, 0, 5}, {0, 4, 5}}}});
}

TEST(DepthBuffer, KnowsWhatIsInFrontAtEachSample) {
  const Scene scene = square_with_triangle();
  const DepthBuffer buffer(scene, 10, 10, 1);
  EXPECT_EQ(buffer.columns(), 10U);
  EXPECT_EQ(buffer.front(9, 9), -1);
  EXPECT_EQ(buffer.front(7, 2), 0);
  EXPECT_EQ(buffer.front(2, 7), 1);
  EXPECT_EQ(buffer.front(1, 1), 2);
  EXPECT_EQ(buffer.front(5, 5), 0) << "the first of two at one depth";
}

TEST(DepthBuffer, LeavesNoGapBetweenTriangles) {
  const Scene scene = scene_of_triangles({{{{1.37, 1.11, 0}, {90.7, 3.3, 0}, {88.8, 91.9, 0}}},
                                          {{{1.37, 1.11, 0}, {88.8, 91.9, 0}, {3.1, 95.2, 0}}}});
  const DepthBuffer buffer(scene, 100, 100, 4);
  for (std::size_t i = 30; i < 350; ++i) EXPECT_GE(buffer.front(i, i), 0) << i;
}

TEST(DepthBuffer, HidesWhatIsBehind) {
  const Scene scene = square_with_triangle();
  const DepthBuffer buffer(scene, 10, 10, 4);
  EXPECT_TRUE(buffer.is_visible({5, 5, 0}));
  EXPECT_FALSE(buffer.is_visible({5, 5, -1}));
  EXPECT_FALSE(buffer.is_visible({1, 1, 0}));
  EXPECT_TRUE(buffer.is_visible({1, 1, 5}));
  EXPECT_TRUE(buffer.is_visible({9, 9, -100})) << "nothing is there";
  EXPECT_FALSE(buffer.is_visible({11, 5, 0})) << "outside";
}

TEST(DepthBuffer, LeavesOutTrianglesWithoutArea) {
  const Scene scene = scene_of_triangles(
      {{{{1, 1, 0}, {9, 9, 0}, {5, 5, 0}}}, {{{3, 3, 0}, {3, 3, 0}, {3, 3, 0}}}});
  const DepthBuffer buffer(scene, 10, 10, 2);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(buffer.front(i, i), -1);
}

TEST(DepthBuffer, CutsTrianglesThatReachFarBeyondThePicture) {
  const Scene scene = scene_of_triangles({{{{-1e7, -1e7, 1}, {1e7, -1e7, 1}, {5, 1e7, 1}}}});
  const DepthBuffer buffer(scene, 10, 10, 4);
  EXPECT_EQ(buffer.front(0, 0), 0);
  EXPECT_EQ(buffer.front(39, 39), 0);
}

TEST(DepthPlane, StaysBetweenTheDepthsOfItsCorners) {
  const DepthPlane plane({{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}});
  EXPECT_DOUBLE_EQ(plane.at(0.25, 0.5), 0.25);
  EXPECT_EQ(plane.at(7, 0), 1);
  EXPECT_EQ(plane.at(-7, 0), 0);
}

}  // namespace
}  // namespace surfmesh
