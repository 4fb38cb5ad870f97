// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/wide_fans.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cage/cages.hh"
#include "surfmesh/cage/cage_model.hh"

namespace surfmesh {
namespace {

/// A fan without ripples at every second place: its vertices lie on a circle.
Cage cone(int faces, double height) {
  Cage cage = testing::quad_fan(faces);
  cage.points[0] = {0, 0, height};
  for (std::size_t i = 1; i < cage.points.size(); ++i) {
    const double angle = std::numbers::pi * double(i - 1) / faces;
    cage.points[i] = {std::cos(angle), std::sin(angle), 0};
  }
  return cage;
}

TEST(WideFans, AreVerticesOfManyFaces) {
  const auto count = [](int faces) {
    const auto fans = wide_fans(model_from_cage(testing::quad_fan(faces)));
    return std::count_if(fans.begin(), fans.end(), [](const auto& f) { return f.size() == 1; });
  };
  EXPECT_EQ(count(static_cast<int>(kWideFan) - 1), 0);
  EXPECT_EQ(count(static_cast<int>(kWideFan)), static_cast<long>(kWideFan));
}

TEST(WideFans, AreNoneInModelsOfFormulas) {
  Model model = model_from_cage(testing::quad_fan(40));
  for (Patch& patch : model.patches) patch.cage_faces.clear();
  for (const auto& fans : wide_fans(model)) EXPECT_TRUE(fans.empty());
}

TEST(WideFans, CountTheCurvatureOfTheConeThatTheFacesMake) {
  // That of a cone is 1 / (r tan α); half of its opening is α, and twice as much counts.
  for (const int faces : {32, 128, 512}) {
    for (const double height : {0.0, 2.0, 6.0}) {
      const double expected = std::max(1.0, 2 * height);
      for (const auto& fans :
           wide_fans(model_from_cage(cone(faces, height), {.patches = PatchKind::Faces}))) {
        ASSERT_EQ(fans.size(), 1u);
        EXPECT_GT(fans[0].turns.at(0), 0.6 * expected) << faces << " " << height;
        EXPECT_LT(fans[0].turns.at(0), 1.5 * expected) << faces << " " << height;
      }
    }
  }
}

/// Curvatures k_x and k_y of a surface that is level at (2, 0, 0).
Jet level_jet(double k_x, double k_y) {
  Jet jet;
  jet.point = {2, 0, 0};
  jet.du = {1, 0, 0};
  jet.dv = {0, 1, 0};
  jet.duu = {0, 0, k_x};
  jet.duv = {0, 0, 0};
  jet.dvv = {0, 0, k_y};
  return jet;
}

PrincipalCurvatures smooth(const Jet& jet, const Vec3& centre, double turn) {
  return without_ripples(principal_curvatures(jet), jet, centre, turn);
}

TEST(WithoutRipples, CurvatureAroundTheVertexIsLimited) {
  const PrincipalCurvatures below = smooth(level_jet(5, -100), {0, 0, 0}, 3);
  EXPECT_DOUBLE_EQ(below.k1, 5);
  EXPECT_DOUBLE_EQ(below.k2, -1.5);
  const PrincipalCurvatures above = smooth(level_jet(5, 100), {0, 0, 0}, 3);
  EXPECT_DOUBLE_EQ(above.k1, 5);
  EXPECT_DOUBLE_EQ(above.k2, 1.5);
  EXPECT_DOUBLE_EQ(above.cos2, 1) << "k1 lies towards the vertex now";
}

TEST(WithoutRipples, CurvatureTowardsTheVertexIsKept) {
  const PrincipalCurvatures k = smooth(level_jet(100, 1), {0, 0, 0}, 3);
  EXPECT_DOUBLE_EQ(k.k1, 100);
  EXPECT_DOUBLE_EQ(k.k2, 1);
}

TEST(WithoutRipples, CurvatureBetweenCountsByTheSquareOfItsCosine) {
  // The vertex lies at 45° to both directions, √2 away.
  const PrincipalCurvatures k = smooth(level_jet(100, 0), {1, 1, 0}, 3);
  EXPECT_DOUBLE_EQ(k.k1, 2 * 3 / std::numbers::sqrt2);
}

/// A closed tube of so many rows of height 0.5, with an n-gon at each end.
Cage barrel(int n, int rows) {
  Cage cage = testing::tube(n, rows);
  for (Vec3& p : cage.points) p.z() *= 0.5;
  cage.faces.resize(cage.faces.size() + 2);
  for (int i = 0; i < n; ++i) {
    cage.faces.end()[-2].push_back(n - 1 - i);
    cage.faces.end()[-1].push_back(rows * n + i);
  }
  return cage;
}

TEST(WithoutRipples, NothingChangesOnSmoothWalls) {
  // The ends of a barrel are fans, and its walls a block that is near both.
  const Model model = model_from_cage(barrel(40, 4));
  const auto fans = wide_fans(model);
  int seen = 0;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const Surface& surface = *model.patches[p].surface;
    const CellCount cells = surface.cells();
    for (int i = 0; i < 400; ++i) {
      const Uv share{std::fmod(i * 0.7549, 1), std::fmod(i * 0.5698, 1)};
      const Jet jet = surface.evaluate(surface.domain().at(share.u, share.v), Order::Second);
      if (std::abs(jet.point.z() - 1) > 0.4) continue;
      const int cell = int(share.v * cells.v) * cells.u + int(share.u * cells.u);
      const PrincipalCurvatures k = principal_curvatures(jet);
      for (const WideFan& fan : fans[p]) {
        const double turn = fan.turns.at(static_cast<std::size_t>(cell));
        const PrincipalCurvatures counted = without_ripples(k, jet, fan.centre, turn);
        EXPECT_EQ(counted.k1, k.k1);
        EXPECT_EQ(counted.k2, k.k2);
        seen += std::isfinite(turn) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(seen, 50);
}

}  // namespace
}  // namespace surfmesh
