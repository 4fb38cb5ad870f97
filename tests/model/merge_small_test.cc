// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/merge_small.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "model/hand_made.hh"
#include "support/notices.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::HandMade;
using testing::rectangle;

constexpr double kLeast = 1e-6;

/// A square of side 10 with a short side in the middle of its lower one.
Model square_with_short_side(double length) {
  HandMade made;
  const int patch = made.add_patch(rectangle(0, 0, 10, 10));
  made.add_loop(patch,
                made.corners_at({{0, 0}, {5, 0}, {5 + length, 0}, {10, 0}, {10, 10}, {0, 10}}));
  made.model.diagonal = 14;
  return made.model;
}

TEST(MergeSmallParts, LeavesOutContoursBelowTheTolerance) {
  Model model = square_with_short_side(1e-8);
  merge_short_contours(model, kLeast);
  EXPECT_EQ(model.contours.size(), 5U);
  EXPECT_EQ(model.patch(0).loops.front().size(), 5U);
  EXPECT_EQ(model.contour(0).end, model.contour(1).start);
  ASSERT_EQ(model.notices.size(), 1U);
  EXPECT_EQ(model.notices[0].kind, NoticeKind::MergedContours);
  EXPECT_EQ(model.notices[0].text,
            "contours that are shorter than the tolerance are left out: 1, the first: 1-2 at "
            "(5, 0, 0)");
}

TEST(MergeSmallParts, LeavesLongerOnes) {
  Model model = square_with_short_side(1e-4);
  merge_short_contours(model, kLeast);
  EXPECT_EQ(model.contours.size(), 6U);
  EXPECT_TRUE(model.notices.empty());
}

TEST(MergeSmallParts, TakesTheToleranceOfAContour) {
  Model model = square_with_short_side(1e-4);
  model.contour(1).tolerance = 2e-4;
  merge_short_contours(model, kLeast);
  EXPECT_EQ(model.contours.size(), 5U);
}

TEST(MergeSmallParts, LeavesRowsThatAreLongerTogether) {
  HandMade made;
  const int patch = made.add_patch(rectangle(0, 0, 10, 10));
  made.add_loop(patch,
                made.corners_at(
                    {{0, 0}, {5, 0}, {5 + 6e-7, 0}, {5 + 1.2e-6, 0}, {10, 0}, {10, 10}, {0, 10}}));
  made.model.diagonal = 14;
  merge_short_contours(made.model, kLeast);
  EXPECT_EQ(made.model.contours.size(), 6U);
}

TEST(MergeSmallParts, LeavesPoles) {
  HandMade made;
  const int patch = made.add_patch(testing::sphere());
  const int south = made.add_vertex({0, 0, -1}), north = made.add_vertex({0, 0, 1});
  const int low = made.add_contour(south, south), side = made.add_contour(south, north);
  const int high = made.add_contour(north, north);
  made.model.patch(patch).loops = {
      {made.add_use(low, patch, {0, -std::numbers::pi / 2},
                    {2 * std::numbers::pi, -std::numbers::pi / 2}),
       made.add_use(side, patch, {2 * std::numbers::pi, -std::numbers::pi / 2},
                    {2 * std::numbers::pi, std::numbers::pi / 2}),
       made.add_use(high, patch, {2 * std::numbers::pi, std::numbers::pi / 2},
                    {0, std::numbers::pi / 2}),
       made.add_use(side, patch, {0, -std::numbers::pi / 2}, {0, std::numbers::pi / 2}, false)}};
  finish(made.model);
  EXPECT_EQ(made.model.contours.size(), 3U);
  EXPECT_TRUE(made.model.contour(0).is_degenerate);
  EXPECT_TRUE(mesh_model(made.model).report.mesh.is_closed);
}

TEST(MergeSmallParts, GivesAMeshWithoutFlatTriangles) {
  Model model = square_with_short_side(1e-8);
  finish(model);
  EXPECT_GT(mesh_model(model).report.quality.min, 0.5);
}

/// Two squares with a patch of no width between them.
Model squares_beside_sliver() {
  HandMade made;
  const int left = made.add_patch(rectangle(0, 0, 1, 1));
  const int sliver = made.add_patch(rectangle(0.9, 0, 1.1, 1));
  const int right = made.add_patch(rectangle(1, 0, 2, 1));
  for (const Uv uv : {Uv{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}}) {
    made.add_vertex({uv.u, uv.v, 0});
  }
  const int near = made.add_contour(1, 2), far = made.add_contour(2, 1);
  made.model.patch(left).loops = {{made.add_use(made.add_contour(0, 1), left, {0, 0}, {1, 0}),
                                   made.add_use(near, left, {1, 0}, {1, 1}),
                                   made.add_use(made.add_contour(2, 3), left, {1, 1}, {0, 1}),
                                   made.add_use(made.add_contour(3, 0), left, {0, 1}, {0, 0})}};
  made.model.patch(sliver).loops = {{made.add_use(near, sliver, {1, 0}, {1, 1}, false),
                                     made.add_use(far, sliver, {1, 1}, {1, 0}, false)}};
  made.model.patch(right).loops = {{made.add_use(made.add_contour(1, 4), right, {1, 0}, {2, 0}),
                                    made.add_use(made.add_contour(4, 5), right, {2, 0}, {2, 1}),
                                    made.add_use(made.add_contour(5, 2), right, {2, 1}, {1, 1}),
                                    made.add_use(far, right, {1, 1}, {1, 0})}};
  made.model.groups.push_back({"all", {0, 1, 2}});
  made.model.diagonal = 2.2;
  return made.model;
}

TEST(MergeSmallParts, LeavesOutPatchesWithoutWidth) {
  Model model = squares_beside_sliver();
  merge_slivers(model, kLeast);
  ASSERT_EQ(model.patches.size(), 2U);
  EXPECT_EQ(model.patch(1).name, "p2");
  EXPECT_EQ(model.groups[0].patches, (std::vector<int>{0, 1}));
  const auto common = std::count_if(model.contours.begin(), model.contours.end(),
                                    [](const Contour& c) { return c.uses.size() == 2; });
  EXPECT_EQ(common, 1);
  EXPECT_EQ(model.notices.back().text,
            "patches that are narrower than the tolerance are left out: 1, the first: p1");
}

TEST(MergeSmallParts, JoinsWhatLiesBesideThem) {
  Model model = squares_beside_sliver();
  finish(model);
  EXPECT_NO_THROW(check(model));
  const MeshResult result = mesh_model(model);
  EXPECT_EQ(result.report.mesh.euler, 1);
}

}  // namespace
}  // namespace surfmesh
