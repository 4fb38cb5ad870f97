// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/creases.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/cage/cage_model.hh"

namespace surfmesh {
namespace {

TEST(Creases, AreWhereFacesMeetAtMoreThanTheAngle) {
  for (const auto& [angle, count] : {std::pair{89.0, 12}, {91.0, 0}}) {
    Cage cage = testing::cube();
    add_creases(angle, cage);
    EXPECT_EQ(cage.creases.size(), static_cast<std::size_t>(count)) << angle;
    for (const Cage::Crease& crease : cage.creases) EXPECT_EQ(crease.sharpness, kSharp);
  }
}

TEST(Creases, OfAPrismAreItsRimsAtAnAngleAboveThatOfItsSides) {
  Cage cage = testing::prism(12);  // its sides meet at 30°
  add_creases(31, cage);
  EXPECT_EQ(cage.creases.size(), 24u);
  add_creases(29, cage);
  EXPECT_EQ(cage.creases.size(), 36u);
}

TEST(Creases, TakeFacesThatAreTurnedAsSeenFromOneSide) {
  Cage cage = testing::sheet(3, 3);
  std::reverse(cage.faces[4].begin(), cage.faces[4].end());
  add_creases(60, cage);
  EXPECT_TRUE(cage.creases.empty());
}

TEST(Creases, BecomeSharperButNeverLess) {
  Cage cage = testing::cube();
  const auto [a, b] = std::pair(cage.faces[0][0], cage.faces[0][1]);
  cage.creases = {{{b, a}, 3}};
  add_crease({a, b}, 2, cage);
  ASSERT_EQ(cage.creases.size(), 1u);
  EXPECT_EQ(cage.creases[0].sharpness, 3);
  add_crease({a, b}, 5, cage);
  EXPECT_EQ(cage.creases[0].sharpness, 5);
}

TEST(Creases, RunAlongAChainOfVertices) {
  Cage cage = testing::cube();
  const std::vector<int> face = cage.faces[0];
  add_crease(face, 4, cage);
  EXPECT_EQ(cage.creases.size(), 3u);
  EXPECT_EQ(error_of([&] {
              add_crease({face[0], face[2]}, 4, cage);
            }),
            "invalid input: vertices " + std::to_string(face[0]) + " and " +
                std::to_string(face[2]) + " are not the ends of an edge");
}

TEST(Creases, RunAroundAGroup) {
  Cage cage = testing::cube();
  cage.groups = {{"two", {0, 1}}};
  const auto shares_edge = [&] {
    int common = 0;
    for (const int v : cage.faces[0]) {
      common += static_cast<int>(std::count(cage.faces[1].begin(), cage.faces[1].end(), v));
    }
    return common == 2;
  };
  add_crease_around("two", 10, cage);
  EXPECT_EQ(cage.creases.size(), shares_edge() ? 6u : 8u);
  EXPECT_EQ(error_of([&] { add_crease_around("tow", 10, cage); }),
            "invalid input: there is no group tow, did you mean two?");
}

TEST(Creases, MakeTheLimitSurfaceOfACubeTheCubeItself) {
  const Model model = model_from_cage(testing::cube(), {.crease_angle = 45});
  for (const Patch& patch : model.patches) {
    const Domain domain = patch.surface->domain();
    const Vec3 a = patch.surface->evaluate(domain.at(0.3, 0.7), Order::First).du;
    const Vec3 b = patch.surface->evaluate(domain.at(0.8, 0.2), Order::First).du;
    EXPECT_LT(a.cross(b).norm(), 1e-9);
  }
  EXPECT_EQ(model.patches.size(), 6u);
}

}  // namespace
}  // namespace surfmesh
