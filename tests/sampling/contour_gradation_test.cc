// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/contour_gradation.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

using testing::size_of;

constexpr double kGrade = 1.5;

/// Control spaces of patches that each want one size everywhere.
struct Controls {
  Model model;
  std::vector<ControlInput> inputs;
  std::vector<std::unique_ptr<ControlSpace>> spaces;
  ContourGradationReport report;
};

Controls graded_controls(Model model, const std::vector<Size>& sizes, double grade = kGrade,
                         ControlKind kind = ControlKind::Cells) {
  Controls controls{std::move(model), {}, {}, {}};
  Sizing sizing{.curvature = 0, .hmin = Length::units(1e-3), .hmax = Length::units(10)};
  sizing.grade = grade;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    const PatchSources sources{{{static_cast<int>(p), sizes[p]}}, {}};
    controls.inputs.push_back(collect_control_input(*controls.model.patches[p].surface,
                                                    resolve(sizing, controls.model.diagonal),
                                                    sources, {.kind = kind}));
    controls.spaces.push_back(make_control(controls.inputs.back()));
  }
  controls.report = grade_across_contours(controls.model, controls.inputs, controls.spaces);
  for (const auto& space : controls.spaces) finish(*space);
  return controls;
}

/// Two squares side by side along x, joined at x = 1.
Model two_squares() {
  return testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
}

SizeTensor size_at(const Controls& controls, std::size_t patch, Uv uv) {
  const Jet jet = controls.model.patches[patch].surface->evaluate(uv, Order::First);
  QueryHint hint;
  return controls.spaces[patch]->size({uv, jet.point, first_form_factor(jet.du, jet.dv)}, hint);
}

TEST(ContourGradation, MakesPatchesAgreeOnTheirContour) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.02, 0.02), size_of(1, 1)});
  EXPECT_GT(controls.report.lowered, 0U);
  for (const double v : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(size_at(controls, 1, {1, v}).h11, 0.02, 0.02 * 0.02) << v;
  }
}

TEST(ContourGradation, MakesMeshesAgreeOnTheirContour) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.02, 0.02), size_of(1, 1)},
                                            kGrade, ControlKind::Mesh);
  EXPECT_GT(controls.report.spaces, 0U);
  for (const double v : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(size_at(controls, 1, {1, v}).h11, 0.02, 0.2 * 0.02) << v;
  }
}

TEST(ContourGradation, LetsSizesGrowFromTheContour) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.02, 0.02), size_of(1, 1)});
  for (const double u : {1.1, 1.5, 2.0}) {
    const double allowed = 0.02 + std::log(kGrade) * (u - 1);
    // Interpolated between few nodes, along edges that are no straight way.
    EXPECT_LT(size_at(controls, 1, {u, 0.5}).h11, 1.6 * allowed) << u;
    EXPECT_GT(size_at(controls, 1, {u, 0.5}).h11, 0.4 * allowed) << u;
  }
}

TEST(ContourGradation, GoesOnThroughPatches) {
  Model row =
      testing::model_of({testing::rectangle(0, 0, 0.1, 1), testing::rectangle(0.1, 0, 0.2, 1),
                         testing::rectangle(0.2, 0, 0.3, 1)});
  const Controls controls =
      graded_controls(std::move(row), {size_of(0.02, 0.02), size_of(1, 1), size_of(1, 1)});
  // As above, and at each contour a twentieth more.
  EXPECT_LT(size_at(controls, 2, {0.3, 0.5}).h11, 1.6 * (0.02 + std::log(kGrade) * 0.2));
}

TEST(ContourGradation, HoldsOnAPartOfASideToItsEnds) {
  // The second square touches a part of the first one's side, which ends between its nodes.
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0.31, 1.42, 0.73)});
  const Controls controls = graded_controls(model, {size_of(1, 1), size_of(0.02, 0.02)});
  for (const double v : {0.31, 0.33, 0.52, 0.71, 0.73}) {
    EXPECT_NEAR(size_at(controls, 0, {1, v}).h11, 0.02, 0.02 * 0.02) << v;
  }
  EXPECT_GT(size_at(controls, 0, {1, 0.2}).h11, 0.02 + 0.8 * std::log(kGrade) * 0.11);
}

TEST(ContourGradation, FollowsSizesThatCameDownAlongARow) {
  // A small third square behind a narrow one: sizes on the part of the side come down in one place,
  // after its row was made for large ones.
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0.31, 1.02, 0.73),
                         testing::rectangle(1.02, 0.46, 1.04, 0.47)});
  const Controls controls =
      graded_controls(model, {size_of(1, 1), size_of(1, 1), size_of(0.005, 0.005)});
  const double least = size_at(controls, 1, {1, 0.465}).h22;
  EXPECT_LT(least, 0.02);
  for (const double v : {0.44, 0.465, 0.48}) {
    EXPECT_NEAR(size_at(controls, 0, {1, v}).h22, size_at(controls, 1, {1, v}).h22, 0.15 * least)
        << v;
  }
}

TEST(ContourGradation, LeavesPatchesThatAgree) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.3, 0.1), size_of(0.3, 0.1)});
  EXPECT_EQ(controls.report, ContourGradationReport());
}

TEST(ContourGradation, IsOffWithoutGrade) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.02, 0.02), size_of(1, 1)}, 0);
  EXPECT_EQ(controls.report, ContourGradationReport());
  EXPECT_EQ(size_at(controls, 1, {1, 0.5}), isotropic(1));
}

TEST(ContourGradation, CarriesDirectionsThroughTurnedParameters) {
  // The second square's u runs along y: the same tensor has its angle turned there.
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1),
                         testing::plane(Vec3(2, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0))});
  const double angle = 0.4;
  const Controls controls = graded_controls(model, {size_of(0.3, 0.05, angle), size_of(5, 5)});
  const SizeTensor expected = size_tensor(0.3, 0.05, angle - std::numbers::pi / 2);
  EXPECT_LT(log_conformity(size_at(controls, 1, {0.5, 1}), expected), 0.25);
}

TEST(ContourGradation, CarriesDirectionsToAPatchOfTheOtherOrientation) {
  // The second square's normal points down: v runs along -y.
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1),
                         testing::plane(Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, -1, 0))});
  const double angle = 0.4;
  const Controls controls = graded_controls(model, {size_of(0.3, 0.05, angle), size_of(5, 5)});
  EXPECT_LT(log_conformity(size_at(controls, 1, {0, 0.5}), size_tensor(0.3, 0.05, -angle)), 0.25);
}

TEST(ContourGradation, LowersGridsToo) {
  const Controls controls = graded_controls(two_squares(), {size_of(0.02, 0.02), size_of(1, 1)},
                                            kGrade, ControlKind::Grid);
  EXPECT_LT(size_at(controls, 1, {1, 0.5}).h11, 0.03);
}

TEST(ContourGradation, ReachesThePoleAtTheEndOfAContour) {
  // Two half cones that share two rulings and their apex, at v = 0.
  const auto half = [](double from) -> testing::Shape {
    return std::make_shared<test::Cone>(1, Domain{from, from + std::numbers::pi, 0, 1});
  };
  const Controls controls = graded_controls(testing::model_of({half(0), half(std::numbers::pi)}),
                                            {size_of(0.05, 0.05), size_of(1, 1)});
  // The pole's own node has no tangent plane to compare in, and shows half a unit around it.
  EXPECT_LT(size_at(controls, 1, {std::numbers::pi, 0.02}).h11, 0.1);
  for (const double v : {0.1, 0.3, 0.9}) {
    EXPECT_LT(size_at(controls, 1, {std::numbers::pi, v}).h11, 0.07) << v;
  }
}

TEST(ContourGradation, JoinsTheTwoSidesOfASeam) {
  // A cylinder of one patch: a small size at one end of u has to act beyond the seam.
  const Model model = testing::model_of({testing::cylinder(0, 2 * std::numbers::pi)});
  Controls controls{model, {}, {}, {}};
  controls.inputs.push_back(
      {model.patches[0].surface->domain(), ControlKind::Mesh, {}, {.grade = kGrade}});
  for (const double u : {0.0, 2 * std::numbers::pi}) {
    for (const double v : {0.0, 1.0}) {
      const Jet jet = model.patches[0].surface->evaluate({u, v}, Order::First);
      controls.inputs[0].nodes.push_back(
          {{u, v}, jet.point, first_form_factor(jet.du, jet.dv), isotropic(u == 0 ? 0.05 : 1)});
    }
  }
  controls.spaces.push_back(make_control(controls.inputs[0]));
  EXPECT_GT(size_at(controls, 0, {6.2, 0.5}).h11, 0.5);
  grade_across_contours(controls.model, controls.inputs, controls.spaces);
  EXPECT_LT(size_at(controls, 0, {2 * std::numbers::pi, 0.5}).h11, 0.06);
}

}  // namespace
}  // namespace surfmesh
