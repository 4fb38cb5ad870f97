// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/surface_walk.hh"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <vector>

#include "support/models.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

constexpr double kWalkRounding = 1e-12;

SurfaceWalk walk_over(const Model& model) { return {model, smooth_contours(model, {})}; }

Vec3 point_at(const Model& model, const SurfacePlace& place) {
  return model.surface(place.patch).evaluate(place.uv, Order::Position).point;
}

void expect_place(const std::optional<WalkEnd>& end, int patch, Uv uv) {
  ASSERT_TRUE(end);
  EXPECT_EQ(end->place.patch, patch);
  EXPECT_NEAR(end->place.uv.u, uv.u, kWalkRounding);
  EXPECT_NEAR(end->place.uv.v, uv.v, kWalkRounding);
}

/// Two unit squares side by side.
Model two_squares() {
  return testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
}

TEST(SmoothContours, AreThoseThatDivideASmoothSurface) {
  const Model model = two_squares();
  const std::vector<char> is_smooth = smooth_contours(model, {});
  ASSERT_EQ(is_smooth.size(), model.contours.size());
  for (std::size_t c = 0; c < is_smooth.size(); ++c) {
    EXPECT_EQ(is_smooth[c] != 0, model.contours[c].uses.size() == 2) << model.contours[c].name;
  }
}

TEST(SmoothContours, LeaveOutCutOnes) {
  const Model model = two_squares();
  int shared = -1;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (model.contours[c].uses.size() == 2) shared = static_cast<int>(c);
  }
  const std::vector<char> is_smooth = smooth_contours(model, {shared});
  EXPECT_EQ(is_smooth[static_cast<std::size_t>(shared)], 0);
}

TEST(SurfaceWalk, StaysInAPatch) {
  const Model model = two_squares();
  const auto end = walk_over(model).go({0, {0.25, 0.5}}, {0.5, -0.25});
  expect_place(end, 0, {0.75, 0.25});
  EXPECT_EQ(end->turn(Uv{1, 0}), (Uv{1, 0}));
}

TEST(SurfaceWalk, GoesOnInTheNeighbour) {
  const Model model = two_squares();
  expect_place(walk_over(model).go({0, {0.75, 0.5}}, {0.5, 0.25}), 1, {1.25, 0.75});
  expect_place(walk_over(model).go({1, {1.25, 0.75}}, {-0.5, -0.25}), 0, {0.75, 0.5});
}

TEST(SurfaceWalk, StartsOnAContour) {
  const Model model = two_squares();
  expect_place(walk_over(model).go({0, {1, 0.5}}, {0.5, 0}), 1, {1.5, 0.5});
  expect_place(walk_over(model).go({0, {1, 0.5}}, {-0.5, 0}), 0, {0.5, 0.5});
  expect_place(walk_over(model).go({1, {1, 0.5}}, {0, 0.25}), 1, {1, 0.75});
}

TEST(SurfaceWalk, GoesThroughTheCornerOfFourPatches) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1),
                         testing::rectangle(0, 1, 1, 2), testing::rectangle(1, 1, 2, 2)});
  expect_place(walk_over(model).go({0, {1, 1}}, {0.5, 0.25}), 3, {1.5, 1.25});
  expect_place(walk_over(model).go({0, {0.5, 0.5}}, {1, 1}), 3, {1.5, 1.5});
  expect_place(walk_over(model).go({3, {1, 1}}, {-0.5, -0.5}), 0, {0.5, 0.5});
}

TEST(SurfaceWalk, TakesStepsToOtherParameters) {
  // The second square has parameters that are turned, and ten times as long.
  const auto turned = std::make_shared<test::PlanePatch>(Vec3(1, 1, 0), Vec3(0, -0.1, 0),
                                                         Vec3(0.1, 0, 0), Domain{0, 10, 0, 10});
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1), turned});
  const auto end = walk_over(model).go({0, {0.5, 0.5}}, {1, 0.25});
  expect_place(end, 1, {2.5, 5});
  const Uv u = end->turn(Uv{1, 0}), v = end->turn(Uv{0, 1});
  EXPECT_NEAR(u.u, 0, kWalkRounding);
  EXPECT_NEAR(u.v, 10, kWalkRounding);
  EXPECT_NEAR(v.u, -10, kWalkRounding);
  EXPECT_NEAR(v.v, 0, kWalkRounding);
}

TEST(SurfaceWalk, GoesAroundACylinderThroughItsSeam) {
  const Model model = testing::model_of({testing::cylinder(0, 2 * pi)});
  expect_place(walk_over(model).go({0, {2 * pi - 0.25, 0.25}}, {0.5, 0.125}), 0, {0.25, 0.375});
  expect_place(walk_over(model).go({0, {0.25, 0.25}}, {-0.5, 0}), 0, {2 * pi - 0.25, 0.25});
}

TEST(SurfaceWalk, ComesBackAfterAWholeTurnOverFourPatches) {
  std::vector<testing::Shape> quarters;
  for (int i = 0; i < 4; ++i) quarters.push_back(testing::cylinder(i * pi / 2, (i + 1) * pi / 2));
  const Model model = testing::model_of(quarters);
  const SurfacePlace start{1, {pi / 2 + 0.5, 0.25}};
  const auto end = walk_over(model).go(start, {2 * pi, 0.5});
  ASSERT_TRUE(end);
  EXPECT_EQ(end->place.patch, 1);
  EXPECT_NEAR((point_at(model, end->place) - point_at(model, start) - Vec3(0, 0, 0.5)).norm(), 0,
              kWalkRounding);
}

TEST(SurfaceWalk, EndsAtBoundariesAndContoursThatMayNotBeCrossed) {
  const Model model = two_squares();
  EXPECT_FALSE(walk_over(model).go({0, {0.5, 0.5}}, {0, 1}));
  EXPECT_FALSE(walk_over(model).go({0, {0.5, 0.5}}, {-1, 0}));
  const SurfaceWalk held(model, std::vector<char>(model.contours.size(), 0));
  EXPECT_FALSE(held.go({0, {0.5, 0.5}}, {1, 0}));
}

TEST(SurfaceWalk, SeesCurvedBoundaries) {
  const Model model = testing::square_with_hole(0.5);
  const SurfaceWalk walk = walk_over(model);
  EXPECT_FALSE(walk.go({0, {0.6, 0}}, {-0.2, 0}));
  EXPECT_FALSE(walk.go({0, {-0.6, 0.1}}, {1.2, 0})) << "over the whole hole";
  expect_place(walk.go({0, {0.6, 0}}, {0.2, 0.1}), 0, {0.8, 0.1});
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * pi * i / 64;
    const Uv out{std::cos(angle), std::sin(angle)};
    EXPECT_TRUE(walk.go({0, 0.51 * out}, 0.4 * out)) << angle;
    EXPECT_FALSE(walk.go({0, 0.51 * out}, -0.1 * out)) << angle;
  }
}

}  // namespace
}  // namespace surfmesh
