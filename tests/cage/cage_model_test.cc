// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_model.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "support/notices.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

int euler(const Model& model) {
  return static_cast<int>(model.vertices.size()) - static_cast<int>(model.contours.size()) +
         static_cast<int>(model.patches.size());
}

/// Laws of every model of a cage.
void expect_valid_cage_model(const Model& model) {
  EXPECT_NO_THROW(check(model));
  for (const Contour& contour : model.contours) {
    ASSERT_FALSE(contour.uses.empty());
    EXPECT_FALSE(contour.uses.size() == 1 && contour.is_smooth) << contour.name;
    for (double t : {0.0, 0.25, 0.7, 1.0}) {
      std::vector<Vec3> points;
      for (const ContourUse& use : contour.uses) {
        const Patch& patch = model.patches[static_cast<std::size_t>(use.patch)];
        points.push_back(patch.surface->evaluate(use.curve->evaluate(t), Order::Position).point);
        EXPECT_LT((points.back() - points.front()).norm(), 1e-9 * model.diagonal) << contour.name;
      }
      const auto near = [&](int vertex) {
        const ModelVertex& v = model.vertices[static_cast<std::size_t>(vertex)];
        return (v.position - points[0]).norm() < 1e-9 * model.diagonal;
      };
      EXPECT_TRUE(t != 0 || near(contour.start)) << contour.name;
      EXPECT_TRUE(t != 1 || near(contour.end)) << contour.name;
    }
  }
}

std::vector<std::string> sharp_contours(const Model& model) {
  std::vector<std::string> names;
  for (const Contour& contour : model.contours) {
    if (!contour.is_smooth) names.push_back(contour.name);
  }
  return names;
}

/// With each face a patch.
Model model_of_faces(const Cage& cage, Scheme scheme = Scheme::Auto) {
  return model_from_cage(cage, {.scheme = scheme, .patches = PatchKind::Faces});
}

TEST(CageModel, UsesOfAContourAgree) {
  Cage tagged = testing::cube();
  tagged.creases = {{{0, 1}, 10}, {{1, 3}, 2.5}};
  tagged.corners = {{7, 10}, {6, 1.5}};
  for (const Cage& cage :
       {testing::cube(), testing::torus(), testing::tetrahedron(), testing::octahedron(),
        testing::icosahedron(), testing::sheet(), testing::triangle_sheet(), testing::pillow(),
        testing::pentagon_prism(), testing::fan(), tagged}) {
    expect_valid_cage_model(model_from_cage(cage));
    expect_valid_cage_model(model_of_faces(cage));
  }
}

TEST(CageModel, HasTheEulerCharacteristicOfTheCage) {
  EXPECT_EQ(euler(model_from_cage(testing::cube())), 2);
  EXPECT_EQ(euler(model_from_cage(testing::torus())), 0);
  EXPECT_EQ(euler(model_from_cage(testing::icosahedron())), 2);
  EXPECT_EQ(euler(model_from_cage(testing::tetrahedron(), {.scheme = Scheme::CatmullClark})), 2);
  EXPECT_EQ(euler(model_from_cage(testing::pentagon_prism())), 2);
  EXPECT_EQ(euler(model_from_cage(testing::sheet())), 1);
}

TEST(CageModel, NamesPatchesAfterFaces) {
  const Model model = model_of_faces(testing::cube());
  ASSERT_EQ(model.patches.size(), 6u);
  EXPECT_EQ(model.patches[3].name, "f3");
  EXPECT_EQ(model.patches[3].cage_faces, std::vector<int>{3});
  EXPECT_DOUBLE_EQ(model.diagonal, 2 * std::sqrt(3.0));
  EXPECT_TRUE(sharp_contours(model).empty());
}

TEST(CageModel, RefinesOnceWhereAFaceIsNotAQuad) {
  const Model model = model_of_faces(testing::pentagon_prism());
  ASSERT_EQ(model.patches.size(), 30u);
  EXPECT_EQ(model.patches[0].name, "f0.0");
  EXPECT_EQ(model.patches[9].name, "f1.4");
  EXPECT_EQ(model.patches[10].name, "f2.0");
  EXPECT_EQ(model.patches[29].cage_faces, std::vector<int>{6});
  EXPECT_EQ(model.contours.size(), 60u);
}

TEST(CageModel, OfARefinedBilinearCageIsTheCage) {
  Cage cage = testing::pentagon_prism();
  const Model model = model_from_cage(cage, {.scheme = Scheme::Bilinear});
  expect_valid_cage_model(model);
  EXPECT_EQ(sharp_contours(model).size(), model.contours.size());
  for (const Vec3& point : cage.points) {
    EXPECT_TRUE(
        std::any_of(model.vertices.begin(), model.vertices.end(),
                    [&](const ModelVertex& v) { return (v.position - point).norm() < 1e-15; }));
  }
}

TEST(CageModel, TellsSharpContours) {
  Cage cage = testing::torus();
  cage.creases = {{{0, 1}, 10}, {{1, 2}, 5}};
  const Model model = model_of_faces(cage);
  expect_valid_cage_model(model);
  EXPECT_EQ(sharp_contours(model), std::vector<std::string>{"e0-1"});
}

TEST(CageModel, KeepsSharpContoursWhenRefined) {
  Cage cage = testing::pentagon_prism();
  cage.creases = {{{0, 1}, 100}};
  EXPECT_EQ(sharp_contours(model_of_faces(cage)).size(), 2u);
}

TEST(CageModel, LeavesOutHoles) {
  Cage cage = testing::cube();
  cage.holes = {1};
  cage.groups = {{"side", {0, 2}}, {"hole", {1}}};
  const Model model = model_of_faces(cage);
  expect_valid_cage_model(model);
  EXPECT_EQ(model.patches.size(), 5u);
  EXPECT_EQ(sharp_contours(model).size(), 4u);
  EXPECT_EQ(model.patches[1].cage_faces, std::vector<int>{2});
  EXPECT_EQ(model.groups[0].patches, (std::vector<int>{0, 1}));
  EXPECT_TRUE(model.groups[1].patches.empty());
}

TEST(CageModel, EndsContoursAtCornersOfHoles) {
  // A block passes a vertex of three faces in the middle of its side, and the boundary turns there.
  Cage cage = testing::cube();
  cage.holes = {1};
  const Model model = model_from_cage(cage, {.patches = PatchKind::Blocks});
  EXPECT_LT(model.patches.size(), 5u);
  std::size_t open = 0;
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 1) continue;
    ++open;
    EXPECT_EQ(contour.part_count(), 1) << contour.name;
  }
  EXPECT_EQ(open, 4u);
}

TEST(CageModel, FollowsTheBoundaryRule) {
  Cage cage = testing::sheet();
  const auto gap = [&cage] {
    const Model model = model_from_cage(cage);
    return (model.vertices[0].position - cage.points[0]).norm();
  };
  EXPECT_GT(gap(), 0.1);
  cage.boundary = BoundaryRule::EdgeAndCorner;
  EXPECT_LT(gap(), 1e-12);
  cage.boundary = BoundaryRule::None;
  EXPECT_EQ(model_from_cage(cage).patches.size(), 1u);
  EXPECT_THROW((void)([&] {
                 cage = testing::sheet(2, 2);
                 cage.boundary = BoundaryRule::None;
                 return model_from_cage(cage);
               }()),
               Error);
}

TEST(CageModel, HasADegenerateContourWhereASideIsAPoint) {
  Cage cage = testing::sheet();
  cage.faces[4] = {5, 6, 6, 9};
  const Model model = model_of_faces(cage);
  expect_valid_cage_model(model);
  EXPECT_EQ(model.patches.size(), 9u);
  int degenerate = 0;
  for (const Contour& contour : model.contours) degenerate += contour.is_degenerate;
  EXPECT_EQ(degenerate, 1);
}

TEST(CageModel, HasThreeUsesOfANonManifoldEdge) {
  const Model model = model_from_cage(testing::fan());
  const auto contour = std::find_if(model.contours.begin(), model.contours.end(),
                                    [](const Contour& c) { return c.uses.size() == 3; });
  ASSERT_NE(contour, model.contours.end());
  EXPECT_FALSE(contour->is_smooth);
  EXPECT_EQ(contour->name, "e1-0");
  EXPECT_EQ(model.contours.size(), 10u);
  EXPECT_EQ(contour->uses[1].is_forward, true);
  EXPECT_EQ(contour->uses[2].is_forward, false);
}

TEST(CageModel, WarnsOfTagsThatMakeNoSense) {
  Cage cage = testing::cube();
  cage.creases = {{{0, 7}, 3}, {{0, 99}, 3}, {{0, 1}, kUnset}};
  cage.corners = {{8, 1}, {0, -1}};
  cage.holes = {-1, 6};
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const Model model = model_of_faces(cage);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "") << "the library does not print";
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(model.patches.size(), 6u);
  ASSERT_EQ(texts_of(model.notices).size(), 7u);
  EXPECT_EQ(texts_of(model.notices)[0],
            "a crease names the edge of vertices 0 and 7, which no face has; the tag is ignored");
  cage = testing::pentagon_prism();
  cage.creases = {{{0, 7}, 3}};
  EXPECT_EQ(texts_of(model_from_cage(cage).notices).size(), 1u);
}

TEST(CageModel, WarnsOfGapsAtChaikinCreases) {
  Cage cage = testing::cube();
  cage.creases = {{{0, 1}, 5}, {{1, 3}, 1}, {{0, 2}, 1}, {{4, 5}, 5}, {{5, 7}, 2}};
  EXPECT_TRUE(texts_of(model_from_cage(cage).notices).empty());
  cage.is_chaikin = true;
  EXPECT_EQ(texts_of(model_from_cage(cage).notices).size(), 1u);
  cage.creases.clear();
  EXPECT_TRUE(texts_of(model_from_cage(cage).notices).empty());
}

// --- blocks ---

const Contour& contour_of(const Model& model, const LoopEntry& entry) {
  return model.contours[static_cast<std::size_t>(entry.contour)];
}

TEST(CageModel, IsOneBlockOfARegularSheet) {
  const Model model = model_from_cage(testing::sheet(5, 3));
  expect_valid_cage_model(model);
  ASSERT_EQ(model.patches.size(), 1u);
  EXPECT_EQ(model.patches[0].name, "f0");
  EXPECT_EQ(model.patches[0].cage_faces.size(), 15u);
  ASSERT_EQ(model.contours.size(), 4u);
  EXPECT_EQ(model.contours[0].name, "e0-1..5");
  EXPECT_EQ(model.contours[0].part_count(), 5);
  EXPECT_EQ(euler(model), 1);
}

TEST(CageModel, HasSeamsWhereABlockMeetsItself) {
  const Model model = model_from_cage(testing::torus(6, 4));
  expect_valid_cage_model(model);
  ASSERT_EQ(model.patches.size(), 1u);
  ASSERT_EQ(model.contours.size(), 2u);
  for (const Contour& contour : model.contours) {
    ASSERT_EQ(contour.uses.size(), 2u);
    EXPECT_NE(contour.uses[0].is_forward, contour.uses[1].is_forward);
    EXPECT_FALSE(contour.is_degenerate);
    EXPECT_TRUE(contour.is_smooth);
  }
  EXPECT_EQ(euler(model), 0);
}

/// A row of three quads, and a row of two beside it that begins one further on.
Cage steps() {
  Cage cage = testing::sheet(3, 2);
  cage.faces.erase(cage.faces.begin() + 3);
  return cage;
}

TEST(CageModel, PartsASideWhereBlocksMeetInATJunction) {
  const Model model = model_from_cage(steps());
  expect_valid_cage_model(model);
  ASSERT_EQ(model.patches.size(), 2u);
  EXPECT_EQ(model.patches[0].loops[0].size() + model.patches[1].loops[0].size(), 9u);
  EXPECT_EQ(std::count_if(model.contours.begin(), model.contours.end(),
                          [](const Contour& c) { return c.uses.size() == 2; }),
            1);
}

TEST(CageModel, EndsBlocksAtGroups) {
  Cage cage = testing::sheet(4, 2);
  cage.groups = {{"left", {0, 1, 4, 5}}, {"all", {0, 1, 2, 3, 4, 5, 6, 7}}};
  const Model model = model_from_cage(cage);
  ASSERT_EQ(model.patches.size(), 2u);
  EXPECT_EQ(model.patches[0].cage_faces, (std::vector<int>{0, 1, 4, 5}));
  EXPECT_EQ(model.groups[0].patches, std::vector<int>{0});
  EXPECT_EQ(model.groups[1].patches, (std::vector<int>{0, 1}));
}

TEST(CageModel, EndsContoursWhereCreasesDo) {
  Cage cage = testing::torus(8, 6);
  cage.creases = {{{0, 1}, 10}, {{1, 2}, 10}};
  const Model model = model_from_cage(cage);
  expect_valid_cage_model(model);
  int sharp_edges = 0;
  for (const Contour& contour : model.contours) {
    if (!contour.is_smooth) sharp_edges += contour.part_count();
  }
  EXPECT_EQ(sharp_edges, 2);
}

TEST(CageModel, HasExtraordinaryVerticesAtEndsOfContours) {
  for (const Cage& cage : {testing::cube(), testing::quad_fan(5), testing::quad_fan(6)}) {
    const Cage refined =
        refine_once(refine_once(cage, Scheme::CatmullClark).cage, Scheme::CatmullClark).cage;
    const Model model = model_from_cage(refined);
    expect_valid_cage_model(model);
    for (const Patch& patch : model.patches) {
      for (const SingularPoint& singular : patch.surface->singular_points()) {
        const Vec3 point = patch.surface->evaluate(singular.at, Order::Position).point;
        EXPECT_TRUE(std::any_of(
            patch.loops[0].begin(), patch.loops[0].end(),
            [&](const LoopEntry& entry) {
              const int start = contour_of(model, entry).start, end = contour_of(model, entry).end;
              const auto at = [&](int v) { return model.vertices[std::size_t(v)].position; };
              return std::min((at(start) - point).norm(), (at(end) - point).norm()) < 1e-9;
            }))
            << patch.name;
      }
    }
  }
}

TEST(CageModel, NamesBlocksOfARefinedCageAfterAPart) {
  Cage cage = testing::sheet(2, 1);
  cage.faces[1] = {1, 2, 5};
  const Model model = model_from_cage(cage);
  expect_valid_cage_model(model);
  EXPECT_EQ(model.patches[0].name, "f0.0");
  EXPECT_EQ(model.patches[0].cage_faces.front(), 0);
  EXPECT_LT(model.patches.size(), 7u);
}

TEST(CageModel, TakesFacesForBlocksUnderOtherSchemes) {
  const std::vector<std::string> told = {
      "only Catmull-Clark cages have blocks; each face is a patch"};
  const CageOptions bilinear = {.scheme = Scheme::Bilinear, .patches = PatchKind::Blocks};
  const Model sheet = model_from_cage(testing::sheet(), bilinear);
  EXPECT_EQ(sheet.patches.size(), 9u);
  EXPECT_EQ(texts_of(sheet.notices), told);
  const Model loop = model_from_cage(testing::icosahedron(), {.patches = PatchKind::Blocks});
  EXPECT_EQ(loop.patches.size(), 20u);
  EXPECT_EQ(texts_of(loop.notices), told);
  EXPECT_TRUE(model_from_cage(testing::icosahedron()).notices.empty());
  EXPECT_TRUE(model_from_cage(testing::sheet(), {.patches = PatchKind::Blocks}).notices.empty());
}

TEST(CageModel, RefusesPointsOnALine) {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 2, 0}, {2, 4, 0}, {3, 6, 0}};
  cage.faces = {{0, 1, 2, 3}};
  EXPECT_EQ(error_of([&] { model_from_cage(cage); }),
            "geometry: the points of the cage lie on a line: its surface has no area");
  cage.points[3].z() = 1e-3;
  EXPECT_EQ(error_of([&] { model_from_cage(cage); }), "no error");
}

TEST(CageModel, RefusesLoopOfQuads) {
  EXPECT_THROW(model_from_cage(testing::cube(), {.scheme = Scheme::Loop}), Error);
}

}  // namespace
}  // namespace surfmesh
