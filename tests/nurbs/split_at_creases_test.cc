// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/split_at_creases.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/nurbs_nets.hh"

namespace surfmesh {
namespace {

using testing::strip_net;

std::vector<NurbsPiece> pieces_of(const NurbsNet& net) {
  return split_at_creases(net, knot_domain(net));
}

/// Two parabolas that meet at u = 1, where the second one begins in this direction.
NurbsNet two_arcs(Vec3 direction) {
  return strip_net(2, {0, 0, 0, 1, 1, 2, 2, 2},
                   {{-2, 0, 1}, {-1, 0, 0}, {0, 0, 0}, direction, {2, 0, 1}});
}

TEST(SplitAtCreases, DividesWhereTangentsTurn) {
  const auto pieces = pieces_of(two_arcs({1, 0, 1}));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].surface->domain().u1, 1);
  EXPECT_EQ(pieces[1].surface->domain().u0, 1);
  EXPECT_EQ(pieces[1].column, 1);
  EXPECT_EQ(pieces[1].row, 0);
}

TEST(SplitAtCreases, DividesAtACusp) { EXPECT_EQ(pieces_of(two_arcs({-1, 0, 0})).size(), 2u); }

TEST(SplitAtCreases, KeepsWholeWhatIsSmooth) {
  EXPECT_EQ(pieces_of(two_arcs({1, 0, 0})).size(), 1u);
  EXPECT_EQ(pieces_of(two_arcs({0.01, 0, 0})).size(), 1u);
  EXPECT_EQ(pieces_of(testing::sphere_net()).size(), 1u);
}

TEST(SplitAtCreases, KeepsWholeWhatIsSmoothByItsKnots) {
  const auto smooth = testing::clamped_knots(3, 5);
  EXPECT_EQ(pieces_of(testing::wavy_net(3, 3, smooth, smooth)).size(), 1u);
}

TEST(SplitAtCreases, LetsPiecesShareTheirLine) {
  const auto pieces = pieces_of(two_arcs({1, 0, 1}));
  ASSERT_EQ(pieces.size(), 2u);
  for (const double v : {0.0, 0.3, 1.0}) {
    const Jet before = pieces[0].surface->evaluate({1, v}, Order::First);
    const Jet behind = pieces[1].surface->evaluate({1, v}, Order::First);
    EXPECT_LE((before.point - behind.point).norm(), 1e-15);
    EXPECT_LE((before.du - Vec3(2, 0, 0)).norm(), 1e-14);
    EXPECT_LE((behind.du - Vec3(2, 0, 2)).norm(), 1e-14);
  }
}

TEST(SplitAtCreases, DividesInBothDirections) {
  const auto pieces =
      pieces_of(testing::wavy_net(1, 1, {0, 0, 1, 2, 2}, {0, 0, 0.5, 0.75, 1, 1}, true));
  ASSERT_EQ(pieces.size(), 6u);
  std::set<std::pair<int, int>> places;
  double area = 0;
  for (const NurbsPiece& piece : pieces) {
    places.insert({piece.column, piece.row});
    const Domain d = piece.surface->domain();
    area += (d.u1 - d.u0) * (d.v1 - d.v0);
  }
  EXPECT_EQ(places.size(), 6u);
  EXPECT_DOUBLE_EQ(area, 2);
}

TEST(SplitAtCreases, DividesPeriodicSurfacesWhereverTheyBegin) {
  NurbsNet square{{1, 1}, {{{0, 1, 2, 3, 4}, {0, 0, 1, 1}}}, {}, {}, {{true, false}}};
  for (const double z : {0.0, 1.0}) {
    square.points.push_back({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
  }
  EXPECT_EQ(pieces_of(square).size(), 4u);
  EXPECT_EQ(split_at_creases(square, {-1.5, 2.5, 0, 1}).size(), 5u);
}

}  // namespace
}  // namespace surfmesh
