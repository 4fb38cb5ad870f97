// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/glue_sides.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

using detail::BorderSide;
using detail::glue_sides;
using detail::GluedSides;

using Edges = std::vector<std::array<int, 2>>;

/// Sides between vertices, of one patch and on no contour.
GluedSides glued(const std::vector<std::array<int, 2>>& ends) {
  std::vector<BorderSide> sides;
  for (const auto& [from, to] : ends) sides.push_back({from, to, -1, 0});
  return glue_sides(sides, Model(), {});
}

TEST(GlueSides, GluesTwoThatLeadOppositeWays) {
  const GluedSides result = glued({{3, 1}, {1, 3}});
  EXPECT_EQ(result.edges, (Edges{{0, 1}}));
  EXPECT_EQ(result.cut, 0u);
}

TEST(GlueSides, LeavesOneAloneOpen) {
  const GluedSides result = glued({{0, 1}});
  EXPECT_EQ(result.edges, (Edges{{0, -1}}));
  EXPECT_EQ(result.cut, 0u);
}

TEST(GlueSides, CutsTwoThatLeadTheSameWay) {
  const GluedSides result = glued({{0, 1}, {0, 1}});
  EXPECT_EQ(result.edges, (Edges{{0, -1}, {1, -1}}));
  EXPECT_EQ(result.cut, 2u);
}

TEST(GlueSides, CutsThree) {
  const GluedSides result = glued({{0, 1}, {1, 0}, {0, 1}});
  EXPECT_EQ(result.edges, (Edges{{0, -1}, {1, -1}, {2, -1}}));
  EXPECT_EQ(result.cut, 3u);
}

TEST(GlueSides, OrdersEdgesByTheirVertices) {
  const GluedSides result = glued({{7, 2}, {5, 0}, {0, 9}, {2, 7}, {9, 0}});
  EXPECT_EQ(result.edges, (Edges{{1, -1}, {2, 4}, {0, 3}}));
}

TEST(GlueSides, HasNothingToDoWithoutSides) { EXPECT_TRUE(glued({}).edges.empty()); }

/// Patches at one contour, all of one solid, with sides around their common edge.
Model patches_at_contour(std::size_t patches) {
  Model model;
  model.patches.resize(patches);
  model.contours.resize(1);
  for (std::size_t p = 0; p < patches; ++p) {
    model.contours[0].uses.emplace_back().patch = static_cast<int>(p);
  }
  return model;
}

TEST(GlueSides, CutsThreePatchesThatNothingJoins) {
  const std::vector<BorderSide> sides = {{0, 1, 0, 0}, {1, 0, 0, 1}, {0, 1, 0, 2}};
  const GluedSides result = glue_sides(sides, patches_at_contour(3), {0});
  EXPECT_EQ(result.edges, (Edges{{0, -1}, {1, -1}, {2, -1}}));
  EXPECT_EQ(result.cut, 3u);
}

}  // namespace
}  // namespace surfmesh
