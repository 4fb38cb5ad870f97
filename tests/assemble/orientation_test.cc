// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/orientation.hh"

#include <gtest/gtest.h>

#include "cage/cages.hh"
#include "support/models.hh"
#include "surfmesh/cage/cage_model.hh"

namespace surfmesh {
namespace {

TEST(OrientPatches, LeavesOnePatchAsItIs) {
  const PatchOrientation orientation = orient_patches(testing::unit_square());
  EXPECT_EQ(orientation.is_turned, std::vector<char>{0});
  EXPECT_TRUE(orientation.cut_contours.empty());
}

TEST(OrientPatches, TurnsTheSecondOfOppositeNormals) {
  const PatchOrientation orientation = orient_patches(testing::opposite_squares());
  EXPECT_EQ(orientation.is_turned, (std::vector<char>{0, 1}));
  EXPECT_TRUE(orientation.cut_contours.empty());
}

TEST(OrientPatches, LeavesPiecesOfOneSurface) {
  for (const Model& model :
       {testing::sphere_of(3), testing::torus_of(4), testing::cylinder_of(2)}) {
    const PatchOrientation orientation = orient_patches(model);
    EXPECT_EQ(orientation.is_turned, std::vector<char>(model.patches.size(), 0));
    EXPECT_TRUE(orientation.cut_contours.empty());
  }
}

TEST(OrientPatches, CutsAMobiusBandOnce) {
  EXPECT_EQ(orient_patches(testing::mobius_band()).cut_contours.size(), 1u);
}

TEST(OrientPatches, DoesNotCutAMobiusBandOfManyPatchesAlongItsLength) {
  const Model model = model_from_cage(testing::mobius_strip(14, 3), {.patches = PatchKind::Faces});
  EXPECT_LE(orient_patches(model).cut_contours.size(), 5u);  // 3 across
}

TEST(OrientPatches, DoesNotPassOverContoursOfThreePatches) {
  const PatchOrientation orientation = orient_patches(testing::three_squares());
  EXPECT_EQ(orientation.is_turned, (std::vector<char>{0, 0, 0}));
  EXPECT_TRUE(orientation.cut_contours.empty());
}

}  // namespace
}  // namespace surfmesh
