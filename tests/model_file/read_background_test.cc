// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_background.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/errors.hh"

namespace surfmesh {
namespace {

/// A quad with values of so many numbers at each vertex.
GridFile grid_with(int components, const std::vector<double>& at_vertex) {
  GridFile grid;
  grid.points = {{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  grid.faces.add(std::vector<int>{0, 1, 2, 3});
  grid.at_points.push_back({"m", components, {}, false});
  std::vector<double>& numbers = grid.at_points.front().numbers;
  for (int v = 0; v < 4; ++v) numbers.insert(numbers.end(), at_vertex.begin(), at_vertex.end());
  return grid;
}

SpaceMetric metric_of(int components, const std::vector<double>& numbers, BackgroundIn in) {
  return background_mesh(grid_with(components, numbers), "", in).metrics.at(3);
}

TEST(BackgroundMesh, HasSizes) {
  const BackgroundMesh mesh = background_mesh(grid_with(1, {0.5}), "m", BackgroundIn::Space);
  EXPECT_EQ(mesh.sizes, std::vector<double>(4, 0.5));
  EXPECT_TRUE(mesh.metrics.empty());
  // The diagonal from 0 to 2 is the shorter one.
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(BackgroundMesh, HasMetricsOfAllForms) {
  const SpaceMetric in_space = {1, 2, 3, 0.4, 0.5, 0.6};
  EXPECT_EQ(metric_of(6, {1, 2, 3, 0.4, 0.5, 0.6}, BackgroundIn::Space), in_space);
  EXPECT_EQ(metric_of(9, {1, 0.4, 0.6, 0.4, 2, 0.5, 0.6, 0.5, 3}, BackgroundIn::Space), in_space);
  for (const auto& numbers : {std::vector<double>{4, 1, 9}, {4, 1, 1, 9}}) {
    const SpaceMetric m = metric_of(static_cast<int>(numbers.size()), numbers, BackgroundIn::Uv);
    EXPECT_EQ(m[0], 4);
    EXPECT_EQ(m[1], 9);
    EXPECT_EQ(m[3], 1);
  }
}

TEST(BackgroundMesh, HasPlaneMetricsInSpace) {
  GridFile grid = grid_with(3, {4, 0, 9});
  EXPECT_EQ(error_of([&] { background_mesh(grid, "", BackgroundIn::Space); }),
            "invalid input: its values m have 3 numbers each; a size has 1, a metric 6 or 9");
  grid.at_points[0].is_plane_tensor = true;
  const SpaceMetric m = background_mesh(grid, "", BackgroundIn::Space).metrics[0];
  EXPECT_EQ(m, (SpaceMetric{4, 9, 6, 0, 0, 0}));
}

TEST(BackgroundMesh, RefusesOtherValues) {
  const auto refused = [](const GridFile& grid, BackgroundIn in) {
    return error_of([&] { background_mesh(grid, "", in); });
  };
  EXPECT_EQ(refused(grid_with(2, {1, 1}), BackgroundIn::Space),
            "invalid input: its values m have 2 numbers each; a size has 1, a metric 6 or 9");
  EXPECT_EQ(refused(grid_with(2, {1, 1}), BackgroundIn::Uv),
            "invalid input: its values m have 2 numbers each; a size has 1, a metric 3, 4, 6 or 9");
  EXPECT_EQ(refused(grid_with(4, {1, 0.5, 0.6, 1}), BackgroundIn::Uv),
            "invalid input: the tensor at vertex 0, from 0, is not symmetric");
  GridFile none = grid_with(1, {1});
  none.at_points.clear();
  EXPECT_EQ(refused(none, BackgroundIn::Space), "invalid input: it has no values at its vertices");
}

}  // namespace
}  // namespace surfmesh
