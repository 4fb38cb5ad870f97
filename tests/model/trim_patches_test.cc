// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/model/join_sides.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::contour_index;
using testing::kSides;
using testing::rectangle;

std::shared_ptr<const Curve> circle_uv(Uv centre, double radius) {
  return std::make_shared<CallableCurve>([=](double t) {
    return centre + Uv{radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t)};
  });
}

std::shared_ptr<const Curve> line(Uv a, Uv b) { return std::make_shared<SegmentCurve>(a, b); }

std::shared_ptr<const SpaceCurve> in_space(std::function<Vec3(double)> function) {
  return std::make_shared<CallableSpaceCurve>(std::move(function));
}

/// The square [-1,1]² with these loops besides its sides.
Model square(std::vector<std::vector<std::string>> holes, std::vector<ContourInput> contours) {
  holes.insert(holes.begin(), kSides);
  return model_from_patches({{"p", rectangle(-1, -1, 1, 1), holes}}, contours);
}

ContourInput hole(double radius = 0.5, Uv centre = {0, 0}, const std::string& name = "hole") {
  return {name, nullptr, {{"p", circle_uv(centre, radius)}}};
}

/// The tests of all that a model promises.
void expect_sound(const Model& model) {
  EXPECT_EQ(error_of([&] { check(model); }), "no error");
  for (const Contour& contour : model.contours) {
    for (const ContourUse& use : contour.uses) {
      for (const double t : {0.0, 0.3, 1.0}) {
        const auto at = [&](const ContourUse& u) {
          return model.patches[static_cast<std::size_t>(u.patch)]
              .surface->evaluate(u.curve->evaluate(t), Order::Position)
              .point;
        };
        if (!use.is_same_speed && t == 0.3) continue;
        EXPECT_LE((at(use) - at(contour.uses[0])).norm(), 1e-6 * model.diagonal) << contour.name;
      }
    }
  }
}

/// Evaluations of the curves of side × side holes while their model is made.
std::size_t evaluations_of_holes(int side) {
  std::size_t count = 0;
  std::vector<std::vector<std::string>> loops;
  std::vector<ContourInput> contours;
  for (int i = 0; i < side * side; ++i) {
    const Uv centre{2 * (i % side + 0.5) / side - 1, 2 * (i / side + 0.5) / side - 1};
    const auto circle = circle_uv(centre, 0.5 / side);
    const std::string name = "hole" + std::to_string(i);
    const auto counted = std::make_shared<CallableCurve>([&count, circle](double t) {
      ++count;
      return circle->evaluate(t);
    });
    contours.push_back({name, nullptr, {{"p", counted}}});
    loops.push_back({"-" + name});
  }
  square(loops, contours);
  return count;
}

// Each hole was looked for in each other one: plates of 900 holes took 12 s.
TEST(TrimPatches, EvaluatesHolesAsOftenWhateverTheirNumber) {
  EXPECT_LT(evaluations_of_holes(12), 9u * 1.3 * static_cast<double>(evaluations_of_holes(4)));
}

TEST(TrimPatches, CutsAHole) {
  const Model model = square({{"-hole"}}, {hole()});
  expect_sound(model);
  ASSERT_EQ(model.patches[0].loops.size(), 2u);
  EXPECT_EQ(model.patches[0].loops[0].size(), 4u);
  const Contour& contour = model.contours.at(4);
  EXPECT_EQ(contour.name, "hole");
  EXPECT_EQ(contour.start, contour.end);
  EXPECT_FALSE(contour.uses[0].is_forward);
  EXPECT_FALSE(contour.is_smooth);
  EXPECT_EQ(model.vertices.size(), 5u);
  EXPECT_TRUE(texts_of(model.notices).empty());
}

TEST(TrimPatches, TurnsALoopWithAWarning) {
  const Model model = square({{"hole"}}, {hole()});
  EXPECT_FALSE(model.contours.at(4).uses[0].is_forward);
  ASSERT_EQ(texts_of(model.notices).size(), 1u);
  EXPECT_EQ(texts_of(model.notices)[0],
            "patch p: loop 1: the loop runs the wrong way round; it is turned");
}

TEST(TrimPatches, TakesTheLargestLoopAsTheOuterOne) {
  const Model model =
      model_from_patches({{"p", rectangle(-1, -1, 1, 1), {{"-hole"}, kSides}}}, {hole()});
  EXPECT_EQ(model.patches[0].loops[0].size(), 4u);
  EXPECT_EQ(model.patches[0].loops[1].size(), 1u);
}

TEST(TrimPatches, JoinsSidesAndContoursEndToEnd) {
  // A corner is cut off, so that two sides are used in part, as contours.
  const std::vector<ContourInput> contours = {{"bottom", nullptr, {{"p", line({-1, -1}, {0, -1})}}},
                                              {"cut", nullptr, {{"p", line({1, 0}, {0, -1})}}},
                                              {"right", nullptr, {{"p", line({1, 0}, {1, 1})}}}};
  const Model model = model_from_patches(
      {{"p", rectangle(-1, -1, 1, 1), {{"bottom", "-cut", "right", "-p:v1", "-p:u0"}}}}, contours);
  expect_sound(model);
  EXPECT_EQ(model.vertices.size(), 5u);
  EXPECT_EQ(model.contours.size(), 5u);
  EXPECT_FALSE(
      model.contours[static_cast<std::size_t>(contour_index(model, "cut"))].uses[0].is_forward);
}

/// A plane and a cylinder through it.
std::vector<PatchInput> plane_and_cylinder(const std::string& on_plane) {
  const auto cylinder = std::make_shared<test::Cylinder>(0.5, Domain{0, 2 * pi, 0, 1});
  return {{"p", rectangle(-1, -1, 1, 1), {kSides, {on_plane}}},
          {"c", cylinder, {{"ring", "c:u1", "-c:v1", "-c:u0"}}}};
}

TEST(TrimPatches, ProjectsAContourInSpace) {
  const auto ring = in_space(
      [](double t) { return Vec3(0.5 * std::cos(2 * pi * t), 0.5 * std::sin(2 * pi * t), 0); });
  const Model model = model_from_patches(plane_and_cylinder("-ring"), {{"ring", ring, {}}});
  expect_sound(model);
  const Contour& contour = model.contours[static_cast<std::size_t>(contour_index(model, "ring"))];
  ASSERT_EQ(contour.uses.size(), 2u);
  EXPECT_TRUE(contour.uses[1].is_same_speed);
  EXPECT_TRUE(contour.uses[1].is_forward);
  EXPECT_FALSE(contour.is_smooth);
  EXPECT_NEAR(contour.uses[1].curve->evaluate(1).u, 2 * pi, 1e-12);
}

TEST(TrimPatches, ProjectsAContourOfAnotherPatch) {
  const Model model = model_from_patches(plane_and_cylinder("-ring"),
                                         {{"ring", nullptr, {{"p", circle_uv({0, 0}, 0.5)}}}});
  expect_sound(model);
  EXPECT_EQ(model.contours[static_cast<std::size_t>(contour_index(model, "ring"))].uses.size(), 2u);
}

TEST(TrimPatches, ProjectsASideOfAnotherPatch) {
  const auto cylinder = std::make_shared<test::Cylinder>(0.5, Domain{0, 2 * pi, 0, 1});
  const Model model =
      model_from_patches({{"p", rectangle(-1, -1, 1, 1), {kSides, {"-c:v0"}}}, {"c", cylinder}});
  expect_sound(model);
  EXPECT_EQ(model.contours[static_cast<std::size_t>(contour_index(model, "c:v0"))].uses.size(), 2u);
  EXPECT_TRUE(texts_of(model.notices).empty());
}

TEST(TrimPatches, TellsDifferentSpeeds) {
  const auto fast = std::make_shared<CallableCurve>([](double t) { return Uv{2 * t * t - 1, 1}; });
  const std::vector<PatchInput> patches = {
      {"p", rectangle(-1, -1, 1, 1), {{"p:v0", "p:u1", "-m", "-p:u0"}}},
      {"q", rectangle(-1, 1, 1, 2), {{"m", "q:u1", "-q:v1", "-q:u0"}}}};
  const Model model =
      model_from_patches(patches, {{"m", nullptr, {{"p", line({-1, 1}, {1, 1})}, {"q", fast}}}});
  const Contour& contour = model.contours[static_cast<std::size_t>(contour_index(model, "m"))];
  ASSERT_EQ(contour.uses.size(), 2u);
  EXPECT_FALSE(contour.uses[1].is_same_speed);
  EXPECT_TRUE(contour.is_smooth);
}

TEST(TrimPatches, TakesASeamTwice) {
  const auto cylinder = std::make_shared<test::Cylinder>(1, Domain{0, 2 * pi, 0, 1});
  const Model model = model_from_patches(
      {{"c", cylinder, {{"c:v0", "seam", "-c:v1", "-seam"}}}},
      {{"seam", nullptr, {{"c", line({2 * pi, 0}, {2 * pi, 1})}, {"c", line({0, 0}, {0, 1})}}}});
  expect_sound(model);
  EXPECT_EQ(model.contours[static_cast<std::size_t>(contour_index(model, "seam"))].uses.size(), 2u);
  EXPECT_EQ(model.vertices.size(), 2u);
}

TEST(TrimPatches, TakesPartOfAPole) {
  const auto wedge = std::make_shared<test::Sphere>(1, Domain{0, 2, 0, pi / 2});
  const Model model =
      model_from_patches({{"s", wedge, {{"low", "right", "-tip", "-left"}}}},
                         {{"low", nullptr, {{"s", line({0.5, 0}, {1.5, 0})}}},
                          {"right", nullptr, {{"s", line({1.5, 0}, {1.5, pi / 2})}}},
                          {"tip", nullptr, {{"s", line({0.5, pi / 2}, {1.5, pi / 2})}}},
                          {"left", nullptr, {{"s", line({0.5, 0}, {0.5, pi / 2})}}}});
  expect_sound(model);
  EXPECT_TRUE(model.contours[2].is_degenerate);
  EXPECT_EQ(model.vertices.size(), 3u);
}

TEST(TrimPatches, WarnsOfAContourThatNoLoopNames) {
  const Model model = square({{"-hole"}}, {hole(), hole(0.1, {0, 0}, "spare")});
  ASSERT_EQ(texts_of(model.notices).size(), 1u);
  EXPECT_EQ(texts_of(model.notices)[0], "contour spare: no loop names it, it is left out");
}

TEST(TrimPatches, WarnsOfContoursThatAreNotJoined) {
  const std::vector<PatchInput> patches = {
      {"p", rectangle(-1, -1, 1, 1), {{"p:v0", "m", "-p:v1", "-p:u0"}}},
      {"q", rectangle(1, -1, 2, 1)}};
  const Model model = model_from_patches(patches, {{"m", nullptr, {{"p", line({1, -1}, {1, 1})}}}});
  ASSERT_EQ(texts_of(model.notices).size(), 1u);
  EXPECT_EQ(texts_of(model.notices)[0],
            "contours m and q:u0 run along each other, at most 0 apart, but are not joined: give "
            "them one name");
}

TEST(TrimPatches, WarnsNotOfContoursAsShortAsTheyAreNear) {
  // A hole as small as contours may be apart: each of its sides is as near to all others.
  const double d = 1e-4;
  const auto side = [&](const char* name, Uv a, Uv b) {
    return ContourInput{name, nullptr, {{"p", line(a, b)}}};
  };
  const Model model =
      square({{"-a", "-d", "-c", "-b"}}, {side("a", {0, 0}, {d, 0}), side("b", {d, 0}, {d, d}),
                                          side("c", {d, d}, {0, d}), side("d", {0, d}, {0, 0})});
  EXPECT_EQ(texts_of(model.notices), std::vector<std::string>{});
}

TEST(TrimPatches, WarnsOfContoursThatNearlyMeet) {
  const Model model = square({{"-hole"}}, {hole(0.5, {0.5 - 1e-5, 0})});
  ASSERT_EQ(texts_of(model.notices).size(), 1u);
  EXPECT_EQ(model.notices[0].patch, 0);
  EXPECT_TRUE(model.notices[0].point.has_value());
  EXPECT_TRUE(texts_of(model.notices)[0].starts_with("patch p: contours "))
      << texts_of(model.notices)[0];
  EXPECT_NE(texts_of(model.notices)[0].find("nearly meet at (u,v) = (0.99999, "), std::string::npos)
      << texts_of(model.notices)[0];
  EXPECT_TRUE(texts_of(model.notices)[0].ends_with(": the gap between them is 1e-05"))
      << texts_of(model.notices)[0];
}

TEST(TrimPatches, DoesNotWarnOfASlit) {
  // Open at the side, and as a hole.
  const double width = 1e-4;
  const std::vector<Uv> corners = {{-1, -1},   {1, -1}, {1, 1}, {width, 1},
                                   {width, 0}, {0, 0},  {0, 1}, {-1, 1}};
  std::vector<ContourInput> contours;
  std::vector<std::string> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(std::string("side").append(std::to_string(i)));
    contours.push_back(
        {loop.back(), nullptr, {{"p", line(corners[i], corners[(i + 1) % corners.size()])}}});
  }
  const Model open = model_from_patches({{"p", rectangle(-1, -1, 1, 1), {loop}}}, contours);
  EXPECT_EQ(texts_of(open.notices), std::vector<std::string>{});
  const auto side = [&](const char* name, Uv a, Uv b) {
    return ContourInput{name, nullptr, {{"p", line(a, b)}}};
  };
  const Model hole = square({{"-a", "-d", "-c", "-b"}},
                            {side("a", {0, 0}, {width, 0}), side("b", {width, 0}, {width, 0.5}),
                             side("c", {width, 0.5}, {0, 0.5}), side("d", {0, 0.5}, {0, 0})});
  EXPECT_EQ(texts_of(hole.notices), std::vector<std::string>{});
}

TEST(TrimPatchesFaults, OfLoopsThatAreAPoint) {
  EXPECT_EQ(error_of([] { square({{"-hole"}}, {hole(0)}); }),
            "geometry: patch p: loop 1: the loop is a single point in space, seen with joining = "
            "2.83e-09");
}

TEST(TrimPatchesFaults, OfCurvesThatAreNotFinite) {
  const auto pole = std::make_shared<CallableCurve>([](double t) { return Uv{1 / t, 0}; });
  EXPECT_EQ(error_of([&] {
              square({{"-a"}}, {{"a", nullptr, {{"p", pole}}}});
            }),
            "geometry: contour a: the curve at t = 0 is not finite");
}

TEST(TrimPatchesFaults, OfCurvesThatNoSampleResolves) {
  const auto wave = [](double t) { return 0.5 + 0.01 * std::sin(1e9 * t); };
  const std::string fault =
      "geometry: contour a: the curve goes to and fro too often to be meshed: it is more than 5000 "
      "times as long as its box";
  const auto on = std::make_shared<CallableCurve>([&](double t) { return Uv{wave(t), t}; });
  EXPECT_EQ(error_of([&] { square({{"-a"}}, {{"a", nullptr, {{"p", on}}}}); }), fault);
  const auto xyz = in_space([&](double t) { return Vec3(wave(t), t, 0); });
  EXPECT_EQ(error_of([&] { square({{"-a"}}, {{"a", xyz, {}}}); }), fault);
}

TEST(TrimPatchesFaults, OfNames) {
  EXPECT_EQ(error_of([] { square({{"-hol"}}, {hole()}); }),
            "invalid input: patch p: loop 1: there is no contour or side hol");
  EXPECT_EQ(error_of([] { square({{}}, {}); }),
            "invalid input: patch p: loop 1: the loop is empty");
  EXPECT_EQ(error_of([] {
              square({{"-hole"}, {"-hole"}}, {hole()});
            }),
            "invalid input: contour hole on patch p: the loops name it more often than it is given "
            "there");
  EXPECT_EQ(error_of([] { square({{"p:u0"}}, {}); }),
            "invalid input: patch p: loop 1: p:u0 is there twice");
  EXPECT_EQ(error_of([] {
              square({}, {hole(), hole()});
            }),
            "invalid input: contour hole: its name is used twice");
  EXPECT_EQ(error_of([] {
              square({}, {{"a", nullptr, {{"q", nullptr}}}});
            }),
            "invalid input: contour a: there is no patch q");
  EXPECT_EQ(error_of([] {
              square({}, {{"a", nullptr, {}}});
            }),
            "invalid input: contour a: it needs a curve in space, or one on a patch");
}

TEST(TrimPatchesFaults, OfLoopsThatDoNotClose) {
  EXPECT_EQ(error_of([] {
              model_from_patches({{"p", rectangle(-1, -1, 1, 1), {{"p:v0", "p:u1", "-p:v1"}}}});
            }),
            "geometry: patch p: loop 0: the loop does not close, the gap between the end of p:v1 "
            "and the start of p:v0 is 2");
}

TEST(TrimPatchesFaults, OfLoopsThatLeapOverASeam) {
  const auto cylinder = std::make_shared<test::Cylinder>(1, Domain{0, 2 * pi, 0, 1});
  const std::string error = error_of([&] { model_from_patches({{"c", cylinder, {{"c:v0"}}}}); });
  EXPECT_NE(error.find("between c:v0 and c:v0 the loop closes in space, but leaps"),
            std::string::npos)
      << error;
}

TEST(TrimPatchesFaults, OfLoopsOutsideTheDomain) {
  const std::string error = error_of([] { square({{"-hole"}}, {hole(0.5, {0.75, 0})}); });
  EXPECT_NE(error.find("geometry: patch p: loop 1: the loop leaves the domain: contour hole at t = "
                       "1, (u,v) = (1.25, "),
            std::string::npos)
      << error;
}

TEST(TrimPatchesFaults, OfLoopsThatCross) {
  const std::string error = error_of([] {
    square({{"-hole"}, {"-other"}}, {hole(), hole(0.3, {0.4, 0}, "other")});
  });
  EXPECT_NE(error.find("geometry: patch p: loops cross: contours "), std::string::npos) << error;
}

TEST(TrimPatchesFaults, OfHolesThatAreNotInside) {
  const auto loops = [](const std::string& second) {
    return model_from_patches({{"p", rectangle(-1, -1, 1, 1), {{"hole"}, {second}}}},
                              {hole(), hole(0.1, {0.8, 0}, "away"), hole(0.2)});
  };
  EXPECT_NE(error_of([&] { loops("-away"); }).find("its name is used twice"), std::string::npos);
  EXPECT_NE(error_of([] {
              model_from_patches({{"p", rectangle(-1, -1, 1, 1), {{"hole"}, {"-away"}}}},
                                 {hole(), hole(0.1, {0.8, 0}, "away")});
            }).find("loop 1: the loop lies outside of the outer loop at"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              square({{"-hole"}, {"-inner"}}, {hole(), hole(0.1, {0, 0}, "inner")});
            }).find("loop 2: the loop lies inside of a hole at"),
            std::string::npos);
}

TEST(TrimPatchesFaults, OfContoursOffTheirPatch) {
  const auto high = in_space(
      [](double t) { return Vec3(0.5 * std::cos(2 * pi * t), 0.5 * std::sin(2 * pi * t), 0.01); });
  const std::string error = error_of([&] { square({{"-hole"}}, {{"hole", high, {}}}); });
  EXPECT_NE(error.find("geometry: contour hole on patch p: its distance from the patch at t = "),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("is 0.01, which must be below 2.83e-06"), std::string::npos) << error;
}

TEST(TrimPatchesFaults, OfContoursThatDifferBetweenPatches) {
  auto patches = plane_and_cylinder("-ring");
  const std::string error = error_of([&] {
    model_from_patches(patches,
                       {{"ring",
                         nullptr,
                         {{"p", circle_uv({0, 0}, 0.5)}, {"c", line({0, 0.25}, {2 * pi, 0.25})}}}});
  });
  EXPECT_NE(error.find("contour ring on patch c: at t = "), std::string::npos) << error;
  EXPECT_NE(error.find("it is 0.25 away from where it is elsewhere"), std::string::npos) << error;
}

TEST(TrimPatchesFaults, NameTheirOrigin) {
  const std::vector<PatchInput> patches = {
      {"p", rectangle(-1, -1, 1, 1), {kSides, {"-a"}}, "/patches/0"}};
  EXPECT_EQ(error_of([&] { model_from_patches(patches); }),
            "invalid input: /patches/0/loops/1: patch p: there is no contour or side a");
}

}  // namespace
}  // namespace surfmesh
