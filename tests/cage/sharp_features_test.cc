// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/sharp_features.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "cage/cages.hh"
#include "surfmesh/cage/mend_cage.hh"

namespace surfmesh {
namespace {

/// A box of n × n quads on each side, or of pairs of triangles.
Cage box(int n, bool is_triangles) {
  Cage cage;
  const auto add_side = [&](const Vec3& origin, const Vec3& u, const Vec3& v) {
    const int first = static_cast<int>(cage.points.size());
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) cage.points.push_back(origin + (u * i + v * j) / n);
    }
    const auto at = [=](int i, int j) { return first + j * (n + 1) + i; };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        if (is_triangles) {
          cage.faces.push_back({a, b, c});
          cage.faces.push_back({a, c, d});
        } else {
          cage.faces.push_back({a, b, c, d});
        }
      }
    }
  };
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  add_side(o, y, x);
  add_side(z, x, y);
  add_side(o, x, z);
  add_side(y, z, x);
  add_side(o, z, y);
  add_side(x, y, z);
  return mend_cage(cage, {.weld = 0.01}).cage;
}

TEST(SharpFeatures, AreTheEdgesOfABox) {
  for (const bool is_triangles : {false, true}) {
    for (const int n : {1, 4}) {
      Cage cage = box(n, is_triangles);
      const SharpFeatures features = tag_features({}, cage);
      EXPECT_EQ(features.creases, static_cast<std::size_t>(12 * n)) << n << is_triangles;
      EXPECT_EQ(cage.creases.size(), features.creases);
      EXPECT_EQ(features.corners, 0U);  // three lines meet there
    }
  }
}

TEST(SharpFeatures, AreNoneWhereRoundPartsAreCoarse) {
  Cage cage = testing::octahedron();  // all its edges turn by 71 degrees
  EXPECT_EQ(tag_features({}, cage).creases, 0U);
  EXPECT_EQ(tag_features(60, cage).creases, 12U);
}

TEST(SharpFeatures, AreAllEdgesAboveAnAngleThatIsGiven) {
  Cage cage = box(2, true);
  EXPECT_EQ(tag_features(100, cage).creases, 0U);
  EXPECT_EQ(tag_features(0, cage).creases, 0U);
  EXPECT_EQ(tag_features(80, cage).creases, 24U);
}

/// Two triangles that meet at a right angle, in the middle of a plane sheet with a slit.
TEST(SharpFeatures, AreNoEdgesThatAreAlone) {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, -1}, {-1, 0, 0}};
  cage.faces = {{0, 1, 2}, {1, 0, 3}};
  // Its ends are on the border, which goes on.
  EXPECT_EQ(tag_features({}, cage).creases, 1U);
  // The only edge above the angle of a closed surface.
  Cage wedge = testing::octahedron();
  wedge.points[4] = {0.55, 0, 0.25};
  const SharpFeatures features = tag_features({}, wedge);
  EXPECT_EQ(features.creases, wedge.creases.size());
  EXPECT_NE(features.creases, 1U);
}

TEST(SharpFeatures, AreTheCornersOfAPlate) {
  Cage cage = testing::sheet(4, 3);
  for (Vec3& point : cage.points) point.z() = 0;
  const SharpFeatures features = tag_features({}, cage);
  EXPECT_EQ(features.creases, 0U);
  ASSERT_EQ(features.corners, 4U);
  EXPECT_EQ(cage.corners[0].vertex, 0);
  EXPECT_EQ(cage.corners[3].vertex, 19);
}

TEST(SharpFeatures, AreNoCornersOfAnOctagon) {
  Cage cage;
  cage.points = {{0, 0, 0}};
  for (int i = 0; i < 8; ++i) {
    cage.points.emplace_back(std::cos(M_PI * i / 4), std::sin(M_PI * i / 4), 0);
    cage.faces.push_back({0, 1 + i, 1 + (i + 1) % 8});
  }
  EXPECT_EQ(tag_features({}, cage).corners, 0U);
}

TEST(SharpFeatures, LeaveTagsAsTheyAre) {
  Cage cage = testing::sheet(4, 3);
  for (Vec3& point : cage.points) point.z() = 0;
  cage.corners = {{0, 1.5}};
  EXPECT_EQ(tag_features({}, cage).corners, 3U);
  EXPECT_EQ(cage.corners[0].sharpness, 1.5);
}

}  // namespace
}  // namespace surfmesh
