// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/build_model.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/errors.hh"
#include "surfmesh/geometry/join_sides.hh"
#include "surfmesh/geometry/plane_surface.hh"

namespace surfmesh {
namespace {

std::shared_ptr<const Surface> plane(const Domain& domain, double z = 0) {
  return std::make_shared<PlaneSurface>(Vec3(0, 0, z), Vec3(1, 0, 0), Vec3(0, 1, 0), domain);
}

std::shared_ptr<const Curve> circle(double radius, double turn) {
  return std::make_shared<CallableCurve>([=](double t) {
    const double angle = turn * 2 * std::numbers::pi * t;
    return Uv{1 + radius * std::cos(angle), 1 + radius * std::sin(angle)};
  });
}

std::shared_ptr<const Curve> segment(Uv a, Uv b) { return std::make_shared<SegmentCurve>(a, b); }

const std::vector<Uv> kSquare = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

Model plate(const std::vector<Uv>& outline, double turn) {
  Model model;
  const int patch = add_patch(model, "plate", plane({0, 9, 0, 9}));
  add_loop(model, patch, polygon_curves("side", outline));
  add_loop(model, patch, {{"hole", circle(0.5, turn)}});
  complete_model(model);
  return model;
}

/// Two squares side by side; the contour between them has the given curves.
Model two_squares(std::shared_ptr<const Curve> left, std::shared_ptr<const Curve> right) {
  Model model;
  const int a = add_patch(model, "a", plane({0, 1, 0, 1}));
  const int b = add_patch(model, "b", plane({1, 2, 0, 1}));
  std::vector<int> v;
  for (const Vec3& p :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
    v.push_back(add_vertex(model, p));
  }
  const auto side = [&](int patch, std::size_t from, std::size_t to) {
    const auto uv = [&](std::size_t i) {
      const Vec3& p = model.vertices[i].position;
      return Uv{p.x(), p.y()};
    };
    const int contour = add_contour(model, "side", v[from], v[to]);
    return add_use(model, contour, patch, segment(uv(from), uv(to)));
  };
  const int shared = add_contour(model, "between", v[1], v[4]);
  const LoopEntry in_a = add_use(model, shared, a, std::move(left));
  const LoopEntry in_b = add_use(model, shared, b, std::move(right), false);
  add_loop(model, a, {side(a, 0, 1), in_a, side(a, 4, 5), side(a, 5, 0)});
  add_loop(model, b, {side(b, 1, 2), side(b, 2, 3), side(b, 3, 4), in_b});
  complete_model(model);
  return model;
}

TEST(BuildModel, TurnsLoopsToTheSideOfThePatch) {
  const std::vector<Uv> clockwise(kSquare.rbegin(), kSquare.rend());
  for (const double turn : {1.0, -1.0}) {
    for (const auto& outline : {kSquare, clockwise}) {
      const Model model = plate(outline, turn);
      EXPECT_EQ(model.contours[0].uses[0].is_forward, outline == kSquare);
      EXPECT_EQ(model.contours[4].uses[0].is_forward, turn < 0);
      EXPECT_EQ(model.contours[4].start, model.contours[4].end);
    }
  }
}

TEST(BuildModel, MeasuresWhatIsInsideTheLoops) {
  EXPECT_NEAR(plate(kSquare, 1).diagonal, std::sqrt(8.0), 1e-12);
}

TEST(BuildModel, MarksContoursOfOneUseAsBoundaries) {
  const Model model = two_squares(segment({1, 0}, {1, 1}), segment({1, 0}, {1, 1}));
  for (const Contour& contour : model.contours) {
    EXPECT_EQ(contour.is_smooth, contour.name == "between") << contour.name;
  }
}

TEST(BuildModel, FindsUsesOfDifferentSpeed) {
  const auto slow = std::make_shared<CallableCurve>([](double t) { return Uv{1, t * t}; });
  const Model same = two_squares(segment({1, 0}, {1, 1}), segment({1, 0}, {1, 1}));
  const Model different = two_squares(segment({1, 0}, {1, 1}), slow);
  EXPECT_TRUE(same.contours[0].uses[1].is_same_speed);
  EXPECT_FALSE(different.contours[0].uses[1].is_same_speed);
}

TEST(BuildModel, AddsHolesToModelsOfWholePatches) {
  Model model = model_from_patches({{"p", plane({0, 2, 0, 2})}});
  add_loop(model, 0, {{"hole", circle(0.5, 1)}});
  complete_model(model);
  EXPECT_EQ(model.patches[0].loops.size(), 2u);
}

TEST(BuildModel, RefusesUsesThatAreApart) {
  const auto bulge = std::make_shared<CallableCurve>([](double t) {
    return Uv{1 + t * (1 - t), t};
  });
  EXPECT_EQ(error_of([&] {
              two_squares(segment({1, 0}, {1, 1}), bulge);
            }).substr(0, 61),
            "geometry: contour between: its curves on patches a and b are ");
}

TEST(BuildModel, RefusesCurvesThatDoNotClose) {
  Model model;
  const int patch = add_patch(model, "p", plane({}));
  add_loop(model, patch, {{"a", segment({0, 0}, {1, 0})}, {"b", segment({1, 0}, {0, 1})}});
  EXPECT_EQ(error_of([&] { complete_model(model); }),
            "geometry: patch p: the loop does not close, the gap between contours b and a is 1");
}

TEST(BuildModel, RefusesLoopsThatRunTheWrongWay) {
  Model model = plate(kSquare, 1);
  std::swap(model.patches[0].loops[0], model.patches[0].loops[1]);
  EXPECT_EQ(error_of([&] { complete_model(model); }),
            "geometry: patch plate: the outer loop with contour hole must run counter-clockwise in "
            "(u,v)");
}

TEST(BuildModel, RefusesUsesThatDoNotEndAtTheirVertices) {
  Model model = plate(kSquare, 1);
  model.vertices[4].position.z() = 1;
  EXPECT_EQ(error_of([&] { complete_model(model); }),
            "geometry: contour hole: on patch plate its start is 1 from its vertex");
}

TEST(BuildModel, RefusesWhatDoesNotExist) {
  Model model;
  EXPECT_EQ(error_of([&] { complete_model(model); }), "invalid input: the model has no patches");
  EXPECT_EQ(error_of([&] { add_patch(model, "p", nullptr); }),
            "invalid input: patch p has no surface");
  add_patch(model, "p", plane({}));
  EXPECT_EQ(error_of([&] { add_patch(model, "p", plane({})); }),
            "invalid input: there is a patch p already");
  EXPECT_EQ(error_of([&] { complete_model(model); }), "invalid input: patch p has no loop");
  EXPECT_EQ(error_of([&] { add_contour(model, "c", 0, 1); }),
            "invalid input: there is no vertex 0, the model has 0");
  EXPECT_EQ(error_of([&] { add_loop(model, 1, Loop{}); }),
            "invalid input: there is no patch 1, the model has 1");
  EXPECT_EQ(error_of([&] {
              add_use(model, -1, 0, segment({0, 0}, {1, 0}));
            }),
            "invalid input: there is no contour -1, the model has 0");
  EXPECT_EQ(error_of([&] {
              add_loop(model, 0, {{"c", nullptr}});
            }),
            "invalid input: contour c has no curve");
  EXPECT_EQ(error_of([&] {
              polygon_curves("side", {{0, 0}, {1, 0}});
            }),
            "invalid input: polygon side has 2 corners, less than 3");
  EXPECT_EQ(error_of([&] { add_vertex(model, Vec3::Constant(kUnset)); }),
            "invalid input: vertex 0: its position is not finite");
}

TEST(CheckModel, NamesContoursWithoutUsesOrCurves) {
  Model model = plate(kSquare, 1);
  model.contours[2].uses[0].curve = nullptr;
  EXPECT_EQ(error_of([&] { check(model); }), "invalid input: contour side2: a use has no curve");
  model.contours[1].uses[0].patch = 7;
  EXPECT_EQ(error_of([&] { check(model); }),
            "invalid input: contour side1: a use names patch 7 of 1");
  model.contours[0].uses.clear();
  EXPECT_EQ(error_of([&] { check(model); }), "invalid input: contour side0: no patch uses it");
}

TEST(CheckModel, RefusesADiagonalThatIsNotSet) {
  Model model = plate(kSquare, 1);
  model.diagonal = 0;
  EXPECT_EQ(error_of([&] { check(model); }),
            "invalid input: the model's diagonal is 0: it has no extent");
}

}  // namespace
}  // namespace surfmesh
