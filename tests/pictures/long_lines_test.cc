// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/long_lines.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "support/meshes.hh"

namespace surfmesh {
namespace {

TEST(EdgeLines, RunThroughEveryEdgeOnce) {
  const PolyMesh mesh = testing::plane_grid(12, 12);
  const auto at = [](VertexHandle vh) { return PicturePoint{double(vh.idx()), 0}; };
  std::set<std::pair<int, int>> drawn;
  std::size_t steps = 0;
  const auto lines = edge_lines(mesh, at);
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i, ++steps) {
      drawn.insert(std::minmax(int(line[i - 1].x), int(line[i].x)));
    }
  }
  EXPECT_EQ(steps, mesh.n_edges());
  EXPECT_EQ(drawn.size(), mesh.n_edges());
  EXPECT_LT(lines.size(), mesh.n_edges() / 4);
}

TEST(LongLines, GoStraightOn) {
  const std::vector<PicturePoint> points = {{0, 0}, {1, 0}, {2, 0}, {1, 1}};
  const auto lines = long_lines(points, {{0, 1}, {1, 3}, {1, 2}});
  ASSERT_EQ(lines.size(), 2U);
  ASSERT_EQ(lines[0].size(), 3U);
  EXPECT_EQ(lines[0][2].x, 2);
  EXPECT_EQ(lines[1].size(), 2U);
}

TEST(LongLines, OfNothingAreNone) { EXPECT_TRUE(long_lines({}, {}).empty()); }

}  // namespace
}  // namespace surfmesh
