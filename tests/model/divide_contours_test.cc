// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/divide_contours.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::kSides;
using testing::rectangle;

/// The outline of a square with sides of length 1, each over a quarter of t.
Uv outline(double t) {
  const double s = 4 * t;
  if (s < 1) return {-0.5 + s, -0.5};
  if (s < 2) return {0.5, -1.5 + s};
  if (s < 3) return {2.5 - s, 0.5};
  return {-0.5, 3.5 - s};
}

std::shared_ptr<const Curve> square_hole() { return std::make_shared<CallableCurve>(outline); }

/// The same, three times as fast at its end as at its start.
std::shared_ptr<const Curve> faster_square_hole() {
  return std::make_shared<CallableCurve>([](double t) { return outline(t * (1 + t) / 2); });
}

Model plate(const std::vector<ContourInput>& contours) {
  return model_from_patches({{"p", rectangle(-1, -1, 1, 1), {kSides, {"-hole"}}}}, contours);
}

std::vector<Vec3> points_of(const Model& model) {
  std::vector<Vec3> points;
  for (const ModelVertex& vertex : model.vertices) points.push_back(vertex.position);
  return points;
}

bool has_point(const Model& model, const Vec3& point) {
  const std::vector<Vec3> points = points_of(model);
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return (p - point).norm() < 1e-9; });
}

void expect_corners_of_hole(const Model& model) {
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) EXPECT_TRUE(has_point(model, {x, y, 0})) << x << ' ' << y;
  }
}

// A hole as one contour lost its corners: no node had to lie there.
TEST(DivideContours, HasAVertexAtEachCornerOfAHole) {
  const Model model = plate({{"hole", nullptr, {{"p", square_hole()}}}});
  EXPECT_EQ(error_of([&] { check(model); }), "no error");
  EXPECT_EQ(model.vertices.size(), 8u);
  expect_corners_of_hole(model);
  ASSERT_EQ(model.contours.size(), 8u);
  EXPECT_EQ(model.contours[4].name, "hole#0");
  EXPECT_EQ(model.contours[7].name, "hole#3");
  ASSERT_EQ(model.patches[0].loops.size(), 2u);
  EXPECT_EQ(model.patches[0].loops[1].size(), 4u);
  EXPECT_TRUE(texts_of(model.notices).empty());
}

TEST(DivideContours, LeavesSmoothContoursWhole) {
  const auto circle = std::make_shared<CallableCurve>([](double t) {
    return Uv{0.5 * std::cos(2 * pi * t), 0.5 * std::sin(2 * pi * t)};
  });
  const Model model = plate({{"hole", nullptr, {{"p", circle}}}});
  EXPECT_EQ(model.contours.back().name, "hole");
}

TEST(DivideContours, DividesCurvesInSpace) {
  const auto in_space = std::make_shared<CallableSpaceCurve>([](double t) -> Vec3 {
    const Uv uv = outline(t);
    return {uv.u, uv.v, 0};
  });
  const Model model = plate({{"hole", in_space}});
  EXPECT_EQ(error_of([&] { check(model); }), "no error");
  EXPECT_EQ(model.contours.size(), 8u);
  expect_corners_of_hole(model);
}

/// The plate with the hole, and another patch in the hole.
Model plate_and_lid(const std::shared_ptr<const Curve>& on_lid) {
  const std::vector<PatchInput> patches = {{"p", rectangle(-1, -1, 1, 1), {kSides, {"-hole"}}},
                                           {"lid", rectangle(-1, -1, 1, 1), {{"hole"}}}};
  return model_from_patches(patches, {{"hole", nullptr, {{"p", square_hole()}, {"lid", on_lid}}}});
}

TEST(DivideContours, DividesAllCurvesOfAContourAtTheSamePoints) {
  for (const auto& on_lid : {square_hole(), faster_square_hole()}) {
    const Model model = plate_and_lid(on_lid);
    EXPECT_EQ(error_of([&] { check(model); }), "no error");
    ASSERT_EQ(model.contours.size(), 8u);
    for (std::size_t c = 4; c < 8; ++c) {
      const Contour& part = model.contours[c];
      ASSERT_EQ(part.uses.size(), 2u);
      for (const double t : {0.0, 1.0}) {
        EXPECT_LE((model.point(part.uses[0], t) - model.point(part.uses[1], t)).norm(), 1e-9);
      }
    }
    expect_corners_of_hole(model);
  }
}

TEST(DivideContours, RefusesANameThatMightBeThatOfAPart) {
  EXPECT_EQ(error_of([&] {
              plate({{"hole#1", nullptr, {{"p", square_hole()}}}});
            }),
            "invalid input: contour hole#1: a name does not begin with - and has no : and no #");
}

TEST(DivideContours, KnowsTheNamesOfParts) {
  EXPECT_TRUE(is_part_of("hole", "hole"));
  EXPECT_TRUE(is_part_of("hole#3", "hole"));
  EXPECT_FALSE(is_part_of("hole2", "hole"));
  EXPECT_FALSE(is_part_of("hol", "hole"));
}

}  // namespace
}  // namespace surfmesh
