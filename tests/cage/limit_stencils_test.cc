// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/limit_stencils.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cage/cages.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

/// Make_limit_surfaces promises so much of the cage's size at its level; Chaikin creases whose
/// sharpness changes are what Bfr does not know.
constexpr double kLevelError = 2e-5;
constexpr double kChaikinError = 1e-2;

Stencils stencils_of(const Cage& cage) {
  return limit_stencils(*make_topology(cage, resolve_scheme(cage, Scheme::Auto)).refiner);
}

std::vector<Vec3> limit_points(const Cage& cage) {
  return limit_points(cage, resolve_scheme(cage, Scheme::Auto));
}

/// The stencils of a cage beside the corners of the surfaces of the cage that has the faces they
/// need, in which the vertices of the cage come first or, if it is refined, after those of faces
/// and edges.
void expect_positions_of_surfaces(const Cage& given) {
  const Scheme scheme = resolve_scheme(given, Scheme::Auto);
  const RefinedCage regular = make_regular(given, scheme);
  const Cage cage = regular.cage;
  const auto surfaces = make_limit_surfaces(cage, scheme);
  const std::vector<Vec3> points = limit_points(cage);
  const double error = diagonal(given) * (given.is_chaikin ? kChaikinError : kLevelError);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    if (!surfaces[f]) continue;
    const std::vector<int>& face = cage.faces[f];
    for (int k = 0; k < surfaces[f]->domain().corner_count(); ++k) {
      const int vertex = face[static_cast<std::size_t>(k)];
      const Vec3 point =
          surfaces[f]->evaluate(surfaces[f]->domain().corner(k), Order::Position).point;
      ASSERT_LT((points[static_cast<std::size_t>(vertex)] - point).norm(), error)
          << "face " << f << " corner " << k << " vertex " << vertex;
    }
  }
}

std::vector<std::filesystem::path> cage_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {SURFMESH_SOURCE_DIR "/models", SURFMESH_SHARED_DIR "/models",
                             SURFMESH_SHARED_DIR "/models/opensubdiv"}) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (has_cage_ending(entry.path())) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(LimitStencils, AreThePositionsOfLimitSurfaces) {
  for (const auto& file : cage_files()) {
    SCOPED_TRACE(file.string());
    const Cage cage = mend_cage(read_cage(file)).cage;
    if (cage.points.size() < 6000) expect_positions_of_surfaces(cage);
  }
}

TEST(LimitStencils, KnowSemiSharpTags) {
  Cage cage = testing::cube();
  cage.creases = {{{0, 1}, 2.5}, {{1, 3}, 1.2}, {{3, 2}, 4}, {{4, 5}, 10}, {{5, 7}, 10}};
  cage.corners = {{6, 1.7}};
  expect_positions_of_surfaces(cage);
  Cage triangles = testing::icosahedron();
  triangles.creases = {{{0, 11}, 2.5}, {{11, 5}, 1.2}, {{5, 0}, 3}};
  expect_positions_of_surfaces(triangles);
}

TEST(LimitStencils, KnowOpenEdgesAndSharpOnes) {
  for (Cage cage : {testing::sheet(), testing::triangle_sheet(), testing::mobius_strip(7, 3)}) {
    expect_positions_of_surfaces(cage);
    cage.boundary = BoundaryRule::EdgeAndCorner;
    expect_positions_of_surfaces(cage);
    cage.boundary = BoundaryRule::None;
    expect_positions_of_surfaces(cage);
  }
}

TEST(LimitStencils, KnowEdgesOfThreeFaces) { expect_positions_of_surfaces(testing::fan()); }

TEST(LimitStencils, KnowVerticesOfTwoFaces) { expect_positions_of_surfaces(testing::pillow()); }

TEST(LimitStencils, KnowHolesBesideSemiSharpTags) {
  Cage cage = testing::cube();
  cage.creases = {{{0, 1}, 2.5}, {{1, 3}, 1.2}, {{3, 2}, 4}};
  cage.corners = {{6, 1.7}};
  for (int hole = 0; hole < 6; ++hole) {
    cage.holes = {hole};
    expect_positions_of_surfaces(cage);
  }
  cage.holes = {0, 1, 2, 3, 4};
  expect_positions_of_surfaces(cage);
  cage.holes.push_back(5);
  for (const Vec3& point : limit_points(cage)) EXPECT_TRUE(point.allFinite());
}

TEST(LimitStencils, KnowOpenBordersBesideSemiSharpTags) {
  for (Cage cage : {testing::sheet(5, 5), testing::triangle_sheet(5, 5)}) {
    cage.boundary = BoundaryRule::None;
    // From the border inwards: most faces at its first vertices have no surface.
    cage.creases = {{{1, 7}, 2.5}, {{7, 13}, 2.5}, {{13, 14}, 10}, {{14, 15}, 10}};
    cage.corners = {{8, 3.2}, {28, 1.5}};
    expect_positions_of_surfaces(cage);
  }
}

TEST(LimitStencils, KnowHolesAtCreaseEndsAndVerticesOfTwoFaces) {
  Cage cage = testing::torus(8, 6);
  cage.creases = {{{9, 10}, 10}, {{10, 11}, 10}};
  for (std::size_t f = 0; f < cage.faces.size(); f += 2) cage.holes.push_back(static_cast<int>(f));
  expect_positions_of_surfaces(cage);
  Cage pillow = testing::pillow();
  for (std::size_t f = 0; f < pillow.faces.size(); ++f) {
    pillow.holes = {static_cast<int>(f)};
    expect_positions_of_surfaces(pillow);
  }
}

/// A sharp crease that goes on as a semi-sharp one ends there once this is gone.
TEST(LimitStencils, KnowSharpCreasesThatGoOnAsSemiSharpOnes) {
  for (Cage cage : {testing::torus(8, 6), testing::triangle_sheet(5, 5)}) {
    for (const double sharpness : {0.5, 1.5, 2.0, 3.3}) {
      cage.creases = {{{13, 14}, 10}, {{14, 15}, sharpness}};
      expect_positions_of_surfaces(cage);
    }
  }
  Cage pillow = testing::pillow();
  pillow.creases = {{{pillow.faces[0][0], pillow.faces[0][1]}, 1.5}};
  expect_positions_of_surfaces(pillow);
}

/// Very sharp tags refine deeply, which is done for some faces after others: here for two groups.
TEST(LimitStencils, AreTheSameInGroupsOfFaces) {
  Cage cage = testing::torus(200, 4);
  for (int i = 0; i < 200; ++i) cage.creases.push_back({{i, (i + 1) % 200}, 7.5});
  expect_positions_of_surfaces(cage);
}

/// A step of subdivision does not change the limit surface.
TEST(LimitStencils, AreThoseOfTheRefinedCage) {
  Cage cage = testing::pentagon_prism();
  cage.creases = {{{0, 1}, 1.5}, {{1, 2}, 10}};
  for (int k = 0; k < 2; ++k) {
    const std::vector<Vec3> coarse = limit_points(cage);
    const RefinedCage refined = refine_once(cage, Scheme::CatmullClark);
    const std::vector<Vec3> fine = limit_points(refined.cage);
    // The vertices of a cage are the corners of its faces' parts, in the order of these.
    std::size_t part = 0;
    for (const std::vector<int>& face : cage.faces) {
      for (const int vertex : face) {
        const std::vector<int>& quad = refined.cage.faces[part++];
        double least = 1;
        for (const int v : quad) {
          least = std::min(
              least, (fine[static_cast<std::size_t>(v)] - coarse[static_cast<std::size_t>(vertex)])
                         .norm());
        }
        EXPECT_LT(least, 2e-4) << vertex;  // the end of the crease, isolated one step further
      }
    }
    cage = refined.cage;
  }
}

TEST(LimitStencils, HaveRowsThatSumToOne) {
  Cage cage = testing::pentagon_prism();
  cage.points.emplace_back(5, 5, 5);  // without faces
  const Stencils stencils = stencils_of(cage);
  ASSERT_EQ(stencils.rows(), static_cast<int>(cage.points.size()));
  for (int v = 0; v < stencils.rows(); ++v) EXPECT_NEAR(stencils.row(v).sum(), 1, 1e-14);
  EXPECT_EQ(stencils.coeff(10, 10), 1);
}

TEST(LimitStencils, AreThePointsOfABilinearCage) {
  const CageTopology topology = make_topology(testing::pentagon_prism(), Scheme::Bilinear);
  const Stencils stencils = limit_stencils(*topology.refiner);
  EXPECT_EQ(stencils.nonZeros(), 10);
  for (int v = 0; v < 10; ++v) EXPECT_EQ(stencils.coeff(v, v), 1);
}

}  // namespace
}  // namespace surfmesh
