// SPDX-License-Identifier: BSD-3-Clause
// Cages that are not what they seem.
#include "surfmesh/cage/mend_cage.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/coincident_points.hh"
#include "surfmesh/cage/turned_faces.hh"

namespace surfmesh {
namespace {

using testing::split;
using testing::turned;

Cage with_face(Cage cage, std::vector<int> face) {
  cage.faces.push_back(std::move(face));
  return cage;
}

/// The kind of the only notice; fails if there is not exactly one with a place.
NoticeKind only_kind(const Notices& notices) {
  EXPECT_EQ(notices.size(), 1U);
  if (notices.empty()) return NoticeKind::BrokenPromise;
  EXPECT_TRUE(notices[0].point.has_value()) << notices[0].text;
  return notices[0].kind;
}

/// Edges of one face, and of three or more.
std::size_t edges_of_other_than_two_faces(const Model& model) {
  return static_cast<std::size_t>(
      std::count_if(model.contours.begin(), model.contours.end(),
                    [](const Contour& contour) { return contour.uses.size() != 2; }));
}

/// The limit surface at corners of the first patch, to tell surfaces from each other.
Vec3 middle_of_first(const Model& model) {
  return model.patches[0].surface->evaluate({0.5, 0.5}, Order::Position).point;
}

TEST(MendCage, LeavesGoodCagesAlone) {
  for (const Cage& cage : {testing::cube(), testing::torus(), testing::mobius_strip(10, 2),
                           testing::prism(16), testing::sheet(4, 4)}) {
    const MendedCage mended = mend_cage(cage, {.weld = 1e-6, .orient = true});
    EXPECT_EQ(mended.cage.faces, cage.faces);
    EXPECT_TRUE(mended.notices.empty());
  }
}

TEST(MendCage, TellsTurnedFacesAndTurnsThem) {
  const Cage cage = turned(testing::cube(), {2, 5});
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::TurnedFaces);
  EXPECT_TRUE(told.at(0).text.starts_with(
      "2 faces are turned against their neighbours, the first: face 2 at (0, -1, 0)"))
      << told[0].text;
  const MendedCage mended = mend_cage(cage, {.orient = true});
  EXPECT_EQ(mended.cage.faces, testing::cube().faces);
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::IgnoredInput);
}

TEST(MendCage, GivesTheSurfaceOfTheCageThatWasMeant) {
  const Cage cage = turned(testing::cube(), {5});
  const Vec3 wanted = middle_of_first(model_from_cage(testing::cube()));
  EXPECT_GT((middle_of_first(model_from_cage(cage)) - wanted).norm(), 0.01);
  EXPECT_EQ(middle_of_first(model_from_cage(cage, {.orient = true})), wanted);
  const Model split_model = model_from_cage(split(testing::cube()));
  EXPECT_GT((middle_of_first(split_model) - wanted).norm(), 0.01);
  const Model welded =
      model_from_cage(split(testing::cube()), {.weld = Length::share(ranges::kWeld.on)});
  EXPECT_LT((middle_of_first(welded) - wanted).norm(), 1e-14);
  EXPECT_EQ(edges_of_other_than_two_faces(welded), 0U);
}

TEST(MendCage, TellsVerticesThatAreNotWelded) {
  const Cage cage = split(testing::cube());
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::OpenSeams);
  EXPECT_TRUE(told.at(0).text.starts_with("24 open edges lie on others")) << told[0].text;
  EXPECT_NE(told[0].text.find("--weld joins them"), std::string::npos) << told[0].text;
  const MendedCage mended = mend_cage(cage, {.weld = 1e-9});
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::IgnoredInput);
  EXPECT_TRUE(mended.notices[0].text.starts_with(
      "welded 16 vertices onto others, the first: vertex 8 onto vertex 0 at (-1, -1, -1)"))
      << mended.notices[0].text;
}

TEST(MendCage, AdvisesAToleranceThatIsEnough) {
  Cage cage = split(testing::cube());
  for (std::size_t i = 0; i < cage.points.size(); ++i) cage.points[i].x() += i % 3 == 0 ? 3e-5 : 0;
  const std::string text = mend_cage(cage).notices.at(0).text;
  const std::size_t start = text.find("--weld ");
  ASSERT_NE(start, std::string::npos) << text;
  const double tolerance = std::stod(text.substr(start + 7));
  EXPECT_GT(tolerance, 3e-5);
  EXPECT_LT(tolerance, 1e-4);
  const MendedCage mended = mend_cage(cage, {.weld = tolerance});
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::IgnoredInput);
}

/// A body with sides of 2e-5, and a seam of two faces that are 5e-5 apart.
Cage seam_beside_short_sides() {
  Cage cage;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] :
         {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {2e-5, 1.0}, {0.0, 1.0}})
      cage.points.emplace_back(x, y, z);
  }
  cage.faces = {{4, 3, 2, 1, 0}, {5, 6, 7, 8, 9}};
  for (int i = 0; i < 5; ++i) cage.faces.push_back({i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5});
  for (const double y : {0.0, 1.00005}) {
    const int first = static_cast<int>(cage.points.size());
    for (const auto& [dx, dy] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      cage.points.emplace_back(3 + dx, y + dy, 0);
    cage.faces.push_back({first, first + 1, first + 2, first + 3});
  }
  return cage;
}

TEST(MendCage, AdvisesNoToleranceThatDoesHarm) {
  const Notices told = mend_cage(seam_beside_short_sides()).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::OpenSeams);
  EXPECT_TRUE(told.at(0).text.ends_with(
      "by up to 5e-05; a --weld that joins them joins ends of sides, too"))
      << told[0].text;
}

TEST(MendCage, AdvisesToWeldFlatFacesOnlyWithoutHarm) {
  Cage cage = testing::cube();
  for (Vec3& point : cage.points) point.z() *= 1e-16;
  EXPECT_TRUE(mend_cage(cage).notices.at(0).text.ends_with("; --weld removes these sides"));
  // A closed surface with a side that is shorter than the tolerance, but has a length.
  cage.points.insert(cage.points.end(), {{3, 0, 0}, {3 + 1e-7, 0, 0}, {3, 1, 0}, {3, 0, 1}});
  for (std::vector<int> face : testing::tetrahedron().faces) {
    for (int& vertex : face) vertex += 8;
    cage.faces.push_back(face);
  }
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::FlatFaces);
  EXPECT_EQ(told.at(0).text.find("--weld"), std::string::npos) << told[0].text;
}

TEST(MendCage, SeesNoSeamInAGap) {
  // Its sides are a hundredth of an edge apart.
  Cage cage = testing::sheet(2, 2);
  for (const std::vector<int>& face : testing::sheet(2, 2).faces) {
    std::vector<int> other = face;
    for (int& vertex : other) vertex += 9;
    cage.faces.push_back(other);
  }
  for (int i = 0; i < 9; ++i)
    cage.points.push_back(cage.points[static_cast<std::size_t>(i)] + Vec3(0, 0, 0.01));
  EXPECT_TRUE(mend_cage(cage).notices.empty());
}

class RepeatedFace : public ::testing::TestWithParam<std::vector<int>> {};

TEST_P(RepeatedFace, IsToldAndLeftOut) {
  Cage cage = with_face(testing::cube(), GetParam());
  cage.groups = {{"copy", {6}}};
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.cage.faces, testing::cube().faces);
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::RepeatedFaces);
  EXPECT_TRUE(mended.notices[0].text.starts_with(
      "left out 1 face given again, the first: face 6, the same as face 1 at (0, 0, 1)"))
      << mended.notices[0].text;
  const Model model = model_from_cage(cage, {.patches = PatchKind::Faces});
  EXPECT_EQ(edges_of_other_than_two_faces(model), 0U);
  EXPECT_EQ(model.groups.at(0).patches, std::vector<int>{1});
}

INSTANTIATE_TEST_SUITE_P(InAnyRotationAndDirection, RepeatedFace,
                         ::testing::Values(std::vector{4, 5, 7, 6}, std::vector{7, 6, 4, 5},
                                           std::vector{6, 7, 5, 4}, std::vector{5, 4, 6, 7}));

TEST(MendCage, LeavesOutAFaceThatIsGivenThrice) {
  const Cage cage = with_face(with_face(testing::cube(), {4, 5, 7, 6}), {5, 4, 6, 7});
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.cage.faces, testing::cube().faces);
  EXPECT_TRUE(only_kind(mended.notices) == NoticeKind::RepeatedFaces);
}

TEST(MendCage, KeepsTheFaceThatAgreesWithItsNeighbours) {
  Cage cage = turned(testing::cube(), {1});
  cage.faces.push_back(testing::cube().faces[1]);
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.stand_ins[1], 6);
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::RepeatedFaces);
}

TEST(MendCage, KeepsTwoFacesBackToBack) {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  cage.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  EXPECT_TRUE(mend_cage(cage).notices.empty());
}

TEST(MendCage, WeldsAFaceThatLiesOnAnother) {
  Cage cage = testing::cube();
  for (const int vertex : {4, 5, 7, 6}) {
    cage.points.push_back(cage.points[static_cast<std::size_t>(vertex)]);
  }
  cage.faces.push_back({8, 9, 10, 11});
  EXPECT_EQ(only_kind(mend_cage(cage).notices), NoticeKind::OpenSeams);
  const MendedCage mended = mend_cage(cage, {.weld = 1e-6});
  EXPECT_EQ(mended.cage.faces, testing::cube().faces);
  EXPECT_EQ(mended.notices.size(), 2U);
}

TEST(MendCage, TellsAClosedSurfaceThatIsGivenTwice) {
  Cage cage = testing::cube();
  cage.points.insert(cage.points.end(), cage.points.begin(), cage.points.end());
  for (std::vector<int> face : testing::cube().faces) {
    for (int& vertex : face) vertex += 8;
    cage.faces.push_back(face);
  }
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::RepeatedFaces);
  EXPECT_TRUE(told.at(0).text.starts_with("6 faces lie on others")) << told.at(0).text;
  EXPECT_EQ(mend_cage(cage, {.weld = 1e-6}).cage.faces, testing::cube().faces);
  // Two cubes that touch in a face are something else.
  for (std::size_t i = 8; i < 16; ++i) cage.points[i].x() += 2;
  EXPECT_TRUE(mend_cage(cage).notices.empty());
}

/// The faces once more, all turned.
Cage with_turned_copies(Cage cage) {
  for (std::size_t f = 0, count = cage.faces.size(); f < count; ++f) {
    cage.faces.emplace_back(cage.faces[f].rbegin(), cage.faces[f].rend());
  }
  return cage;
}

TEST(MendCage, LeavesOutASurfaceThatIsGivenAgainTurned) {
  for (const Cage& cage :
       {testing::cube(), testing::torus(), testing::sheet(3, 3), testing::tetrahedron()}) {
    const MendedCage mended = mend_cage(with_turned_copies(cage));
    EXPECT_EQ(mended.cage.faces, cage.faces);
    EXPECT_EQ(only_kind(mended.notices), NoticeKind::RepeatedFaces);
  }
}

TEST(MendCage, TellsAClosedSurfaceThatIsGivenTwiceTurned) {
  Cage cage = testing::cube();
  cage.points.insert(cage.points.end(), cage.points.begin(), cage.points.end());
  for (const std::vector<int>& face : testing::cube().faces) {
    std::vector<int>& other = cage.faces.emplace_back(face.rbegin(), face.rend());
    for (int& vertex : other) vertex += 8;
  }
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::RepeatedFaces);
  EXPECT_TRUE(told.at(0).text.starts_with("6 faces lie on others")) << told.at(0).text;
  EXPECT_EQ(mend_cage(cage, {.weld = 1e-6}).cage.faces, testing::cube().faces);
}

/// 3 × 3 faces around the middle one have all of its edges.
TEST(MendCage, LeavesOutAPartOfASurfaceThatIsGivenAgainTurned) {
  const Cage whole = testing::sheet(5, 5);
  Cage cage = whole;
  for (const int row : {1, 2, 3}) {
    for (const int column : {1, 2, 3}) {
      const std::vector<int>& face = whole.faces[static_cast<std::size_t>(5 * row + column)];
      cage.faces.emplace_back(face.rbegin(), face.rend());
    }
  }
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.cage.faces, whole.faces);
  EXPECT_EQ(only_kind(mended.notices), NoticeKind::RepeatedFaces);
}

/// Two bodies of 3 × 3 columns, each with the nine faces between them.
TEST(MendCage, KeepsTheDoubleWallBetweenTwoBodies) {
  const Cage sheet = testing::sheet(3, 3);
  Cage cage = with_turned_copies(sheet);
  const std::vector<int> ring = {0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4};
  for (const double height : {3.0, -3.0}) {
    const int first = static_cast<int>(cage.points.size());
    for (const Vec3& point : sheet.points) cage.points.push_back(point + Vec3(0, 0, height));
    for (const std::vector<int>& face : sheet.faces) {
      std::vector<int>& lid = cage.faces.emplace_back(face);
      for (int& vertex : lid) vertex += first;
      if (height < 0) std::reverse(lid.begin(), lid.end());
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      cage.faces.push_back({a, b, b + first, a + first});
      if (height < 0) std::reverse(cage.faces.back().begin(), cage.faces.back().end());
    }
  }
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.cage.faces, cage.faces);
  EXPECT_TRUE(mended.notices.empty());
}

TEST(MendCage, KeepsOneFaceOfCopiesInBothDirections) {
  Cage cage = turned(testing::cube(), {1});
  cage.faces.push_back(cage.faces[1]);
  cage.faces.push_back(testing::cube().faces[1]);
  cage.faces.push_back(testing::cube().faces[1]);
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.stand_ins, (std::vector<int>{0, 7, 2, 3, 4, 5, 7, 7, 7}));
}

/// A face of the cube is given again, as it is or turned, and one of the two is a hole.
class RepeatedHole : public ::testing::TestWithParam<std::tuple<bool, int>> {};

TEST_P(RepeatedHole, NeverReplacesASurface) {
  const auto [is_turned, hole] = GetParam();
  const std::vector<int> face = testing::cube().faces[0];
  Cage cage =
      with_face(testing::cube(), is_turned ? std::vector(face.rbegin(), face.rend()) : face);
  cage.holes = {hole};
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.stand_ins[0], 6 - hole);
  EXPECT_EQ(mended.stand_ins[6], 6 - hole);
  EXPECT_TRUE(mended.cage.holes.empty());
  // The surface is kept even if it is turned.
  ASSERT_EQ(mended.notices.size(), is_turned && hole == 0 ? 2U : 1U);
  EXPECT_EQ(mended.notices.at(0).kind, NoticeKind::RepeatedFaces);
  EXPECT_NE(mended.notices.at(0).text.find(
                fmt::format("; 1 is a hole where the surface is kept, the first: face {}", hole)),
            std::string::npos)
      << mended.notices[0].text;
  EXPECT_EQ(model_from_cage(cage, {.patches = PatchKind::Faces}).patches.size(), 6U);
}

INSTANTIATE_TEST_SUITE_P(InAnyOrderAndDirection, RepeatedHole,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(0, 6)));

TEST(MendCage, MergesHolesWithHoles) {
  Cage cage = with_face(testing::cube(), testing::cube().faces[0]);
  cage.holes = {0, 6};
  const MendedCage mended = mend_cage(cage);
  EXPECT_EQ(mended.cage.faces, testing::cube().faces);
  EXPECT_EQ(mended.cage.holes, std::vector<int>{0});
  EXPECT_EQ(mended.notices.at(0).text.find("hole"), std::string::npos);
}

TEST(MendCage, CountsNoVertexThatNoFaceUses) {
  Cage cage = split(testing::cube());
  cage.points.emplace_back(1e7, 0, 0);
  EXPECT_DOUBLE_EQ(diagonal(cage), std::sqrt(12.0));
  const Notices told = mend_cage(cage).notices;
  EXPECT_EQ(only_kind(told), NoticeKind::OpenSeams);
  EXPECT_EQ(told.at(0).text, mend_cage(split(testing::cube())).notices.at(0).text);
  const Model model = model_from_cage(cage, {.weld = Length::share(ranges::kWeld.on)});
  EXPECT_DOUBLE_EQ(model.diagonal, std::sqrt(12.0));
  EXPECT_EQ(model.box.max(), Vec3(1, 1, 1));
  EXPECT_EQ(edges_of_other_than_two_faces(model), 0U);
}

TEST(MendCage, WeldsOntoNoVertexThatNoFaceUses) {
  Cage cage;
  cage.points = {{0, 0, 1e-3}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  cage.faces = {{1, 2, 3}};
  EXPECT_EQ(mend_cage(cage, {.weld = 0.01}).cage.faces, cage.faces);
}

TEST(MendCage, TellsFacesWithSidesWithoutLength) {
  Cage cage = testing::cube();
  for (Vec3& point : cage.points) point.z() *= 1e-16;
  EXPECT_EQ(only_kind(mend_cage(cage).notices), NoticeKind::FlatFaces);
  const MendedCage mended = mend_cage(cage, {.weld = 1e-6});
  EXPECT_EQ(mended.cage.faces, (std::vector<std::vector<int>>{{0, 2, 3, 1}, {0, 1, 3, 2}}));
  EXPECT_EQ(mended.parent_faces, (std::vector<int>{0, 1}));
}

TEST(MendCage, WeldsTags) {
  Cage cage = split(testing::cube());
  cage.creases = {{{20, 21}, 2.0}};
  cage.corners = {{23, 3.0}};
  const MendedCage mended = mend_cage(cage, {.weld = 1e-6});
  // The corners of the first two faces are the first ones in their places.
  EXPECT_EQ(
      mended.cage.faces,
      (std::vector<std::vector<int>>{
          {0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 5, 4}, {1, 7, 6, 2}, {0, 4, 7, 1}, {3, 2, 6, 5}}));
  EXPECT_EQ(mended.cage.creases.at(0).edge, (std::array{3, 2}));
  EXPECT_EQ(mended.cage.corners.at(0).vertex, 5);
}

TEST(MendCage, LeavesFacesTheirNumbersInMessages) {
  Cage cage = testing::cube();
  cage.faces.insert(cage.faces.begin(), cage.faces[0]);
  cage.faces[6] = {1, 3, 3, 7, 5};
  cage.faces.push_back({0, 1, 0});
  const Notices notices = model_from_cage(cage).notices;
  ASSERT_EQ(notices.size(), 3U);
  EXPECT_TRUE(notices[1].text.starts_with("face 7 comes back to a vertex")) << notices[1].text;
  EXPECT_TRUE(notices[2].text.starts_with("face 6 has the same vertex twice in a row"))
      << notices[2].text;
  const auto loop = [&] { model_from_cage(cage, {.scheme = Scheme::Loop}); };
  EXPECT_EQ(error_of(loop),
            "invalid input: face 0 has 4 vertices: the Loop scheme knows triangles only");
  cage = testing::octahedron();
  cage.faces.insert(cage.faces.begin(), cage.faces[0]);
  cage.faces.push_back({0, 2, 1, 3});
  EXPECT_EQ(error_of(loop),
            "invalid input: face 9 has 4 vertices: the Loop scheme knows triangles only");
}

TEST(MendCage, ChecksItsInput) {
  EXPECT_EQ(error_of([] {
              mend_cage(with_face(testing::cube(), {0, 1, 99}));
            }),
            "invalid input: face 6 names vertex 99, but there are only 8 points");
  EXPECT_EQ(error_of([] { model_from_cage(testing::cube(), {.weld = Length::units(-1)}); }),
            error_of([] { mend_cage(testing::cube(), {.weld = -1}); }));
  const auto error_for = [](double weld) {
    return error_of([weld] { mend_cage(testing::cube(), {.weld = weld}); });
  };
  EXPECT_TRUE(error_for(-1).starts_with("invalid option: weld = -1")) << error_for(-1);
  EXPECT_TRUE(error_for(NAN).starts_with("invalid option: weld = nan")) << error_for(NAN);
  EXPECT_TRUE(error_for(INFINITY).starts_with("invalid option: weld = inf")) << error_for(INFINITY);
  EXPECT_EQ(error_for(10),
            "invalid option: weld = 10 leaves no face of the cage (its diagonal is 3.46)");
}

TEST(MendCage, TellsHowManyFacesVanishWhereVerticesAreWelded) {
  Cage cage;
  cage.points = {{0, 0, 0}, {0.1, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0.1, 4, 0}, {3, 4, 0}};
  cage.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  const MendedCage mended = mend_cage(cage, {.weld = 0.2});
  EXPECT_EQ(mended.cage.faces.size(), 1u);
  ASSERT_EQ(mended.notices.size(), 2u);
  EXPECT_EQ(mended.notices[1].kind, NoticeKind::LostFaces);
  EXPECT_EQ(mended.notices[1].text,
            "weld = 0.2 leaves out 1 of 2 faces, which have no area then, the first: face 0 at "
            "(0.05, 2, 0); the diagonal of the cage is 5");
}

TEST(CoincidentPoints, AreWithinTheTolerance) {
  const std::vector<Vec3> row = {{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {2.7, 0, 0}, {0, 0, 5}};
  EXPECT_EQ(coincident_points(row, 1), (std::vector<int>{0, 0, 2, 2, 4}));
  EXPECT_EQ(coincident_points(row, 0.1), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(coincident_points({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, 0), (std::vector<int>{0, 0, 0}));
}

TEST(CoincidentPoints, AreFoundAtAnyDistanceBesideFarPoints) {
  const std::vector<Vec3> points = {{1e15, 0, 0}, {0, 0, 0}, {1e-9, 0, 0}, {0, 1e-6, 0}, {0, 1, 0}};
  EXPECT_EQ(coincident_points(points, 1e-8), (std::vector<int>{0, 1, 1, 3, 4}));
  EXPECT_EQ(coincident_points(points, 1e-300), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(TurnedFaces, AreTheFewerOnes) {
  const Cage cage = turned(testing::cube(), {0, 1, 3, 5});
  EXPECT_EQ(turned_faces(cage.faces), (std::vector<char>{0, 0, 1, 0, 1, 0}));
  EXPECT_EQ(turned_faces(testing::mobius_strip(10, 2).faces), std::vector<char>(20, 0));
}

}  // namespace
}  // namespace surfmesh
