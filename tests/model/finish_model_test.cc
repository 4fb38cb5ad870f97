// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/finish_model.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "model/hand_made.hh"
#include "support/errors.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::HandMade;
using testing::rectangle;

/// Two squares beside each other, without anything that finish() sets. Points of the common side
/// are at t² on the second.
Model two_squares(bool is_same_speed) {
  HandMade made;
  const int left = made.add_patch(rectangle(0, 0, 1, 1)),
            right = made.add_patch(rectangle(1, 0, 2, 1));
  for (int i = 0; i < 6; ++i) made.add_vertex(Vec3::Constant(kUnset));
  const int common = made.add_contour(1, 2);
  made.model.patch(left).loops = {{made.add_use(made.add_contour(0, 1), left, {0, 0}, {1, 0}),
                                   made.add_use(common, left, {1, 0}, {1, 1}),
                                   made.add_use(made.add_contour(2, 3), left, {1, 1}, {0, 1}),
                                   made.add_use(made.add_contour(3, 0), left, {0, 1}, {0, 0})}};
  made.model.patch(right).loops = {{made.add_use(made.add_contour(1, 4), right, {1, 0}, {2, 0}),
                                    made.add_use(made.add_contour(4, 5), right, {2, 0}, {2, 1}),
                                    made.add_use(made.add_contour(5, 2), right, {2, 1}, {1, 1}),
                                    made.add_use(common, right, {1, 0}, {1, 1}, false)}};
  if (!is_same_speed) {
    made.model.contour(common).uses[1].curve = std::make_shared<CallableCurve>([](double t) {
      return Uv{1, t * t};
    });
  }
  return made.model;
}

TEST(FinishModel, SetsWhatFollowsFromPatchesAndContours) {
  Model model = two_squares(true);
  finish(model);
  EXPECT_NEAR(model.diagonal, std::sqrt(5.0), 1e-15);
  EXPECT_EQ(model.position(4), Vec3(2, 0, 0));
  EXPECT_TRUE(model.contour(0).is_smooth);
  EXPECT_TRUE(model.contour(0).uses[1].is_same_speed);
  EXPECT_FALSE(model.contour(1).is_smooth);
  EXPECT_NO_THROW(check(model));
}

TEST(FinishModel, FindsUsesOfAnotherSpeed) {
  Model model = two_squares(false);
  finish(model);
  EXPECT_FALSE(model.contour(0).uses[1].is_same_speed);
  EXPECT_LT(gap_of(model, model.contour(0)), 1e-15);
  const MeshResult result = mesh_model(model);
  EXPECT_EQ(result.report.mesh.euler, 1);
  EXPECT_TRUE(result.report.notices.empty());
}

TEST(FinishModel, MeasuresGapsBetweenUses) {
  Model model = two_squares(true);
  model.patch(1).surface = std::make_shared<test::PlanePatch>(Vec3(0, 0, 1e-3), Vec3::UnitX(),
                                                              Vec3::UnitY(), Domain{1, 2, 0, 1});
  for (Contour& contour : model.contours) contour.tolerance = 2e-3;
  finish(model);
  EXPECT_NEAR(gap_of(model, model.contour(0)), 1e-3, 1e-12);
}

TEST(FinishModel, RefusesAPatchWithoutSurface) {
  Model model = two_squares(true);
  model.patch(0).surface = nullptr;
  EXPECT_NE(error_of([&] { finish(model); }).find("patch p0 has no surface"), std::string::npos);
}

TEST(FinishModel, RefusesWhatDoesNotExist) {
  const auto error_with = [](auto change) {
    Model model = two_squares(true);
    change(model);
    return error_of([&] { finish(model); });
  };
  EXPECT_NE(
      error_with([](Model& m) { m.contour(0).end = 9; }).find("its end vertices do not exist"),
      std::string::npos);
  EXPECT_NE(error_with([](Model& m) { m.contour(0).uses[0].patch = -1; }).find("a use names patch"),
            std::string::npos);
  EXPECT_NE(error_with([](Model& m) { m.contour(0).uses[0].curve = nullptr; }).find("no curve"),
            std::string::npos);
  EXPECT_NE(error_with([](Model& m) {
              m.patch(0).loops[0][0].contour = 99;
            }).find("a loop names contour 99"),
            std::string::npos);
}

TEST(Check, AllowsGapsWithinTheTolerances) {
  Model model = two_squares(true);
  finish(model);
  model.contour(1).uses[0].curve = std::make_shared<SegmentCurve>(Uv{0, 0}, Uv{1, 1e-4});
  EXPECT_NE(error_of([&] { check(model); }).find("the loop does not close"), std::string::npos);
  model.contour(1).tolerance = 2e-4;
  EXPECT_NO_THROW(check(model));
  EXPECT_EQ(greatest_tolerance(model), 2e-4);
}

}  // namespace
}  // namespace surfmesh
