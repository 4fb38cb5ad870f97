// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/sharp_features.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cage/meshes.hh"
#include "surfmesh/cage/creases.hh"
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

/// Edges above the angle are many where a coarse mesh is rough, but they make no lines.
TEST(SharpFeatures, AreNoShortLinesOnARoughMesh) {
  Cage mesh = testing::with_noise(testing::sphere_mesh(2), 0.1);
  const std::vector<std::array<int, 2>> edges = edges_above(kFeatureAngle, mesh);
  EXPECT_GT(edges.size(), 40U);
  EXPECT_EQ(tag_features({}, mesh).creases, 0U);
}

/// A sheet with a fold along y = n / 2, that turns by the angle at each of its m edges, degrees.
Cage folded_sheet(int m, int n, const std::vector<double>& angles) {
  Cage cage = testing::triangle_sheet(m, n);
  for (Vec3& point : cage.points) {
    const auto column = static_cast<std::size_t>(std::lround(point.x()));
    const double slope = std::tan(angles[std::min(column, angles.size() - 1)] / 360 * M_PI);
    point.z() = -slope * std::abs(point.y() - n / 2);
  }
  return cage;
}

TEST(SharpFeatures, GoOnAlongWeakerEdges) {
  Cage cage = folded_sheet(9, 4, {60, 55, 50, 45, 35, 33, 35, 45, 50, 60});
  EXPECT_LT(edges_above(kFeatureAngle, cage).size(), 8U);
  EXPECT_EQ(tag_features({}, cage).creases, 9U);
  for (const Cage::Crease& crease : cage.creases) {
    EXPECT_EQ(crease.edge[0] / 10, 2);
    EXPECT_EQ(crease.edge[1] / 10, 2);
  }
}

TEST(SharpFeatures, DoNotStartAtWeakEdges) {
  Cage cage = folded_sheet(9, 4, std::vector<double>(10, 35));
  EXPECT_EQ(tag_features({}, cage).creases, 0U);
}

/// Where most of a line is weak, the mesh resolves a rounding.
TEST(SharpFeatures, AreNoneWhereMostEdgesAreWeak) {
  Cage cage = folded_sheet(9, 4, {50, 50, 35, 35, 35, 35, 35, 35, 35, 35});
  EXPECT_EQ(tag_features({}, cage).creases, 0U);
}

/// Lines that end on both sides need four edges for each end.
TEST(SharpFeatures, AreLongOrHaveNoEnds) {
  Cage shorter = folded_sheet(9, 4, {0, 0, 50, 50, 50, 50, 50, 0, 0, 0});
  EXPECT_EQ(tag_features({}, shorter).creases, 0U);
  Cage to_border = folded_sheet(9, 4, {50, 50, 50, 50, 50, 50, 0, 0, 0, 0});
  EXPECT_GE(tag_features({}, to_border).creases, 4U);
}

/// A crease may end at the border of a hole, which gets no corner.
TEST(SharpFeatures, MayEndAtHoles) {
  Cage cage = folded_sheet(9, 4, {0, 0, 0, 50, 50, 50, 0, 0, 0, 0});
  EXPECT_EQ(tag_features({}, cage).creases, 0U);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    double mean = 0;
    for (const int v : cage.faces[f]) mean += cage.points[static_cast<std::size_t>(v)].x() / 3;
    if (mean < 3 || mean > 5) cage.holes.push_back(static_cast<int>(f));
  }
  EXPECT_EQ(border_edges(cage).size(), 2U * 2 + 2 * 4);
  const SharpFeatures features = tag_features({}, cage);
  EXPECT_EQ(features.creases, 2U);
  EXPECT_EQ(features.corners, 0U);  // those of the sheet have tags by now
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
