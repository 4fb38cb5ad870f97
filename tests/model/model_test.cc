// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/model.hh"

#include <gtest/gtest.h>

#include <string>

#include "support/errors.hh"
#include "surfmesh/geometry/plane_surface.hh"
#include "surfmesh/model/join_sides.hh"

namespace surfmesh {
namespace {

Model square() {
  const auto plane = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                                                    Domain{0, 1, 0, 1});
  return model_from_patches({{"p", plane}});
}

std::string fault(const Model& model) {
  return error_of([&] { check(model); });
}

TEST(FindPatch, IsByNameAndSuggestsWhatWasMeant) {
  Model model = square();
  model.patches.push_back(model.patches[0]);
  model.patches[1].name = "wing";
  EXPECT_EQ(find_patch(model, "wing"), 1);
  EXPECT_EQ(error_of([&] { find_patch(model, "wnig"); }),
            "invalid input: the model has no patch wnig, did you mean wing?");
}

TEST(FindGroup, HasThePatchesOfAllGroupsOfTheName) {
  Model model = square();
  model.groups = {{"grip", {2, 0}}, {"other", {1}}, {"grip", {0, 3}}};
  EXPECT_EQ(find_group(model, "grip"), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(error_of([&] { find_group(model, "grap"); }),
            "invalid input: the model has no group grap, did you mean grip?");
}

TEST(CheckModel, NamesContoursThatNoPatchUses) {
  Model model = square();
  model.contours.push_back({"spare", 0, 1, {}});
  EXPECT_EQ(fault(model), "invalid input: contour spare: no patch uses it");
}

TEST(CheckModel, NamesUsesWithoutPatchOrCurve) {
  Model model = square();
  model.contours[2].uses[0].curve = nullptr;
  EXPECT_EQ(fault(model), "invalid input: contour p:v1: a use has no curve");
  model.contours[1].uses[0].patch = 7;
  EXPECT_EQ(fault(model), "invalid input: contour p:u1: a use names patch 7 of 1");
}

TEST(CheckModel, NamesPatchesWithoutSurfaceOrLoop) {
  Model model = square();
  model.patches[0].loops.clear();
  EXPECT_EQ(fault(model), "invalid input: patch p has no loop");
  model.patches[0].surface = nullptr;
  EXPECT_EQ(fault(model), "invalid input: patch p has no surface");
}

TEST(CheckModel, RefusesCoordinatesWithoutDigitsForTheShape) {
  for (const double distance : {1e9, 1e10, 1e12, 1e15}) {
    const auto plane = std::make_shared<PlaneSurface>(Vec3(0, -distance, 0), Vec3::UnitX(),
                                                      Vec3::UnitY(), Domain{0, 1, 0, 1});
    const std::string told = fault(model_from_patches({{"p", plane}}));
    if (distance < 1e11) {
      EXPECT_EQ(told, "no error") << distance;
    } else {
      EXPECT_TRUE(told.starts_with("invalid input: the model lies too far from the origin"))
          << told;
    }
  }
}

TEST(Model, LeadsFromALoopToTheUseOfItsPatch) {
  const Model model = square();
  for (const LoopEntry& entry : model.patch(0).loops.front()) {
    EXPECT_EQ(&model.contour(entry), &model.contour(entry.contour));
    EXPECT_EQ(&model.use(entry), &model.contour(entry).uses[0]);
    EXPECT_EQ(&model.patch(model.use(entry)), &model.patches[0]);
    EXPECT_EQ(&model.surface(model.use(entry)), model.patches[0].surface.get());
  }
}

TEST(Model, HasItsVerticesAtTheEndsOfContours) {
  const Model model = square();
  for (const Contour& contour : model.contours) {
    EXPECT_EQ(model.point(contour.uses[0], 0), model.position(contour.start)) << contour.name;
    EXPECT_EQ(model.point(contour.uses[0], 1), model.position(contour.end)) << contour.name;
  }
}

TEST(Model, HasPointsOfContoursOnTheirPatches) {
  const Model model = square();
  const Contour& right = model.contour(1);
  ASSERT_EQ(right.name, "p:u1");
  EXPECT_EQ(model.point(right.uses[0], 0.25), Vec3(1, 0.25, 0));
}

}  // namespace
}  // namespace surfmesh
