// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/box_tree.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace surfmesh {
namespace {

using Box = BoxTree::Box;

std::vector<Box> random_boxes(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0, 1), width(0, 0.2);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(at(random), at(random), at(random));
    boxes.push_back({low, low + Vec3(width(random), width(random), width(random))});
  }
  return boxes;
}

TEST(BoxTree, FindsTheBoxesThatMeetInGrowingOrder) {
  const std::vector<Box> boxes = random_boxes(500);
  const BoxTree tree(boxes);
  for (const Box& box : boxes) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].intersects(box)) expected.push_back(i);
    }
    EXPECT_EQ(tree.meeting(box), expected);
  }
}

TEST(BoxTree, CountsPointsOfBordersAsCommon) {
  const BoxTree tree({{Vec3(0, 0, 0), Vec3(1, 1, 1)}});
  EXPECT_EQ(tree.meeting({Vec3(1, 1, 1), Vec3(2, 2, 2)}).size(), 1u);
}

TEST(BoxTree, LeavesOutBoxesThatAreEmptyOrNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Box all(Vec3::Constant(-infinite), Vec3::Constant(infinite));
  const BoxTree tree({Box(), {Vec3(nan, 0, 0), Vec3(1, 1, 1)}, all});
  EXPECT_EQ(tree.meeting(all), std::vector<std::size_t>{2});
  EXPECT_TRUE(BoxTree({}).meeting(all).empty());
}

/// Boxes compared in all for a query of each square of a grid of side × side.
std::size_t comparisons(int side) {
  std::vector<Box> boxes;
  for (int i = 0; i < side * side; ++i) {
    const Uv low{static_cast<double>(i % side), static_cast<double>(i / side)};
    boxes.push_back(plane_box(low, low + Uv{0.5, 0.5}));
  }
  const BoxTree tree(boxes);
  std::size_t compared = 0;
  for (const Box& box : boxes) compared += tree.visit(box, [](std::size_t) {});
  return compared;
}

TEST(BoxTree, ComparesAboutTheLogarithmOfAllBoxes) {
  EXPECT_LT(comparisons(64), 16u * 1.6 * static_cast<double>(comparisons(16)));
}

}  // namespace
}  // namespace surfmesh
