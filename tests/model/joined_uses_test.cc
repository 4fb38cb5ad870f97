// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/joined_uses.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/hand_made.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/model/finish_model.hh"

namespace surfmesh {
namespace {

using testing::HandMade;

/// Half planes that leave the z axis in these directions, in degrees. The normal p_u × p_v of each
/// is on the side of the smaller angle; `is_reversed` turns its outside over.
Model fan(const std::vector<double>& degrees, const std::vector<bool>& is_reversed, int solid) {
  HandMade made;
  const int bottom = made.add_vertex({0, 0, 0}), top = made.add_vertex({0, 0, 1});
  const int axis = made.add_contour(bottom, top);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const int patch = made.add_patch(
        std::make_shared<test::PlanePatch>(Vec3::Zero(), out, Vec3::UnitZ(), Domain{0, 1, 0, 1}));
    const int far = made.add_vertex(out), far_top = made.add_vertex(out + Vec3::UnitZ());
    made.model.patch(patch).loops = {
        {made.add_use(made.add_contour(bottom, far), patch, {0, 0}, {1, 0}),
         made.add_use(made.add_contour(far, far_top), patch, {1, 0}, {1, 1}),
         made.add_use(made.add_contour(far_top, top), patch, {1, 1}, {0, 1}),
         made.add_use(axis, patch, {0, 0}, {0, 1}, false)}};
    made.model.patch(patch).is_reversed = is_reversed[i];
    made.model.patch(patch).solid = solid;
  }
  finish(made.model);
  return made.model;
}

TEST(JoinedUses, AreThoseOfTwoPatches) {
  EXPECT_EQ(joined_uses(fan({0, 90}, {false, false}, -1))[0], (std::vector<UsePair>{{0, 1}}));
}

TEST(JoinedUses, AreNoneOfOnePatchOrThree) {
  EXPECT_TRUE(joined_uses(fan({0}, {false}, -1))[0].empty());
  EXPECT_TRUE(joined_uses(fan({0, 90, 180}, {false, false, false}, 0))[0].empty());
}

TEST(JoinedUses, AreThoseWithTheMaterialOfASolidBetweenThem) {
  // The outside of a patch that is not reversed is where angles are smaller: material is between
  // 0° and 90°, and between 180° and 270°.
  const auto joined = joined_uses(fan({0, 90, 180, 270}, {false, true, false, true}, 3))[0];
  EXPECT_EQ(joined, (std::vector<UsePair>{{0, 1}, {2, 3}}));
}

TEST(JoinedUses, AreNoneWhereMaterialAndAirDoNotAlternate) {
  EXPECT_TRUE(joined_uses(fan({0, 90, 180, 270}, {false, false, true, true}, 3))[0].empty());
}

TEST(JoinedUses, AreNoneOfFourPatchesThatAreNoSolid) {
  EXPECT_TRUE(joined_uses(fan({0, 90, 180, 270}, {false, true, false, true}, -1))[0].empty());
}

TEST(OrientPatches, FollowsMostOfTheMarks) {
  EXPECT_EQ(orient_patches(fan({0, 90}, {true, false}, 0)).is_turned, (std::vector<char>{1, 0}));
  EXPECT_EQ(orient_patches(fan({0, 90}, {false, true}, 0)).is_turned, (std::vector<char>{0, 1}));
}

}  // namespace
}  // namespace surfmesh
