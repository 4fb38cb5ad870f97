// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/patch_region.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/models.hh"

namespace surfmesh {
namespace {

TEST(PatchRegion, OfAnUntrimmedPatchIsWhole) {
  for (const auto& shape :
       {testing::rectangle(-1, 2, 3, 5), testing::sphere(), testing::whole_torus()}) {
    const PatchRegion region(testing::model_of({shape}), 0);
    EXPECT_TRUE(region.is_whole());
    EXPECT_TRUE(region.segments_at({{0, 3}, {1, 3}, {0, 4}}).empty());
  }
}

TEST(PatchRegion, LeavesOutAHole) {
  const PatchRegion region(testing::square_with_hole(0.5), 0);
  EXPECT_FALSE(region.is_whole());
  for (const double angle : {0.1, 1.0, 2.5, 4.0, 6.0}) {
    const Uv direction{std::cos(angle), std::sin(angle)};
    EXPECT_FALSE(region.contains(0.49 * direction));
    EXPECT_TRUE(region.contains(0.51 * direction));
  }
}

TEST(PatchRegion, FindsTheSegmentsThroughATriangle) {
  const PatchRegion region(testing::square_with_hole(0.5), 0);
  EXPECT_TRUE(region.segments_at({{-0.1, -0.1}, {0.1, -0.1}, {0, 0.1}}).empty());
  EXPECT_TRUE(region.segments_at({{0.7, 0.7}, {0.8, 0.7}, {0.7, 0.8}}).empty());
  const UvTriangle at_rim{{0.4, -0.05}, {0.6, -0.05}, {0.5, 0.05}};
  const std::vector<int> found = region.segments_at(at_rim);
  EXPECT_GE(found.size(), 2u);
  EXPECT_LE(found.size(), 6u);
  // Each once, and the same among all of them.
  EXPECT_EQ(region.segments_at(at_rim, found), found);
}

}  // namespace
}  // namespace surfmesh
