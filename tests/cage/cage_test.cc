// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage.hh"

#include <gtest/gtest.h>

#include "cage/cages.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/core/error.hh"

#include "support/notices.hh"

namespace surfmesh {
namespace {

using testing::cube;

void expect_refused(const Cage& cage, const std::string& text) {
  try {
    check(cage);
    ADD_FAILURE() << "expected: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidInput);
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(Cage, HasTheDiagonalOfItsPoints) {
  EXPECT_DOUBLE_EQ(diagonal(cube()), 2 * std::sqrt(3.0));
  EXPECT_EQ(diagonal(Cage{}), 0);
}

TEST(Cage, IsLoopIfAllFacesAreTriangles) {
  Cage cage = testing::octahedron();
  EXPECT_EQ(resolve_scheme(cage, Scheme::Auto), Scheme::Loop);
  EXPECT_EQ(resolve_scheme(cage, Scheme::Bilinear), Scheme::Bilinear);
  cage.is_smooth_triangles = true;
  EXPECT_EQ(resolve_scheme(cage, Scheme::Auto), Scheme::CatmullClark);
  EXPECT_EQ(resolve_scheme(cube(), Scheme::Auto), Scheme::CatmullClark);
}

TEST(Cage, IsRefusedWithTheFaceNamed) {
  Cage cage = cube();
  cage.faces[3] = {0, 1, 8};
  expect_refused(cage, "face 3 names vertex 8");
  cage.faces[3] = {0, 1, -1};
  expect_refused(cage, "face 3 names vertex -1");
  cage.faces[3] = {0, 1};
  expect_refused(cage, "face 3 has fewer than three vertices");
  cage.faces[3] = {0, 1, 0, 2};
  expect_refused(cage, "face 3 comes back to a vertex");
  expect_refused(Cage{}, "no faces");
}

TEST(Cage, IsRefusedWithThePointNamed) {
  Cage cage = cube();
  cage.points[5].y() = kUnset;
  expect_refused(cage, "point 5 is not finite");
}

TEST(Cage, MayHaveASideThatIsAPoint) {
  Cage cage = cube();
  cage.faces[3] = {2, 6, 6, 3};
  EXPECT_NO_THROW(check(cage));
  EXPECT_EQ(without_repeats({4, 1, 1, 2, 4}), (std::vector<int>{4, 1, 2}));
  EXPECT_FALSE(is_simple({1, 1, 2, 2}));
  EXPECT_THROW(refine_once(cage, Scheme::CatmullClark), Error);
}

TEST(MakeRegular, LeavesOutSidesThatArePointsForLoop) {
  Cage cage = testing::tetrahedron();
  cage.faces[1].push_back(cage.faces[1].back());
  const RefinedCage regular = make_regular(cage, Scheme::Loop);
  EXPECT_EQ(texts_of(regular.notices).size(), 1u);
  EXPECT_EQ(regular.cage.faces, testing::tetrahedron().faces);
}

TEST(MakeRegular, LeavesOutFacesThatAreNotSimple) {
  Cage cage = testing::pentagon_prism();
  cage.faces.insert(cage.faces.begin() + 1, {0, 1, 0, 2});
  cage.faces.push_back({0, 0, 1, 2});
  cage.holes = {1, 2};
  cage.groups = {{"all", {0, 1, 2, 3, 4, 5, 6, 7}}};
  const RefinedCage regular = make_regular(cage, Scheme::CatmullClark);
  EXPECT_TRUE(regular.is_refined);
  EXPECT_EQ(texts_of(regular.notices).size(), 2u);
  EXPECT_EQ(regular.cage.faces.size(), 33u);
  EXPECT_EQ(regular.parent_faces[5], 2);
  EXPECT_EQ(regular.parent_faces.back(), 8);
  EXPECT_EQ(regular.cage.holes, (std::vector<int>{5, 6, 7, 8, 9}));
  EXPECT_EQ(regular.cage.groups[0].faces.size(), 30u);
}

TEST(RefineOnce, MakesQuadsThatKnowTheirParents) {
  const RefinedCage refined = refine_once(testing::pentagon_prism(), Scheme::CatmullClark);
  EXPECT_EQ(refined.cage.faces.size(), 30u);
  EXPECT_EQ(refined.cage.points.size(), 10u + 15u + 7u);
  for (const auto& face : refined.cage.faces) EXPECT_EQ(face.size(), 4u);
  EXPECT_EQ(refined.parent_faces[4], 0);
  EXPECT_EQ(refined.parent_faces[5], 1);
  EXPECT_NO_THROW(check(refined.cage));
}

TEST(RefineOnce, ReducesSharpnessByOne) {
  Cage cage = cube();
  cage.creases = {{{0, 1}, 2.5}, {{2, 3}, 10}, {{4, 5}, 0.5}};
  cage.corners = {{7, 3}};
  cage.holes = {1};
  cage.groups = {{"top", {1, 2}}};
  const RefinedCage refined = refine_once(cage, Scheme::CatmullClark);
  int reduced = 0, infinite = 0;
  for (const Cage::Crease& crease : refined.cage.creases) {
    (crease.sharpness == 1.5 ? reduced : infinite) += 1;
    EXPECT_TRUE(crease.sharpness == 1.5 || crease.sharpness == 10) << crease.sharpness;
  }
  EXPECT_EQ(reduced, 2);
  EXPECT_EQ(infinite, 2);
  ASSERT_EQ(refined.cage.corners.size(), 1u);
  EXPECT_EQ(refined.cage.corners[0].sharpness, 2);
  EXPECT_EQ(refined.cage.holes, (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(refined.cage.groups[0].faces.size(), 8u);
}

}  // namespace
}  // namespace surfmesh
