// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/paint_order.hh"

#include <gtest/gtest.h>

#include "pictures/scenes.hh"

namespace surfmesh {
namespace {

using testing::scene_of_triangles;

bool contains(const PaintPiece& piece, double x, double y) {
  bool has_left = false, has_right = false;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const ScenePoint &a = piece.corners[i], &b = piece.corners[(i + 1) % piece.corners.size()];
    const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    has_left = has_left || side > 0;
    has_right = has_right || side < 0;
  }
  return !(has_left && has_right);
}

/// Samples at which the piece that is drawn last is not the triangle in front.
int wrong_samples(const Scene& scene, int samples = 4) {
  const DepthBuffer buffer(scene, 100, 100, samples);
  const auto layers = paint_order(scene, buffer);
  int wrong = 0;
  for (std::size_t row = 0; row < buffer.rows(); ++row) {
    for (std::size_t column = 0; column < buffer.columns(); ++column) {
      PackedRgb last = 0, front = 0;
      const double x = (double(column) + 0.5) / samples, y = (double(row) + 0.5) / samples;
      for (const auto& layer : layers) {
        for (const PaintPiece& piece : layer) {
          if (contains(piece, x, y)) last = piece.colour;
        }
      }
      const int t = buffer.front(column, row);
      if (t >= 0) front = scene.triangles[static_cast<std::size_t>(t)].colour;
      wrong += last != front ? 1 : 0;
    }
  }
  return wrong;
}

std::size_t count(const std::vector<std::vector<PaintPiece>>& layers) {
  std::size_t sum = 0;
  for (const auto& layer : layers) sum += layer.size();
  return sum;
}

TEST(PaintOrder, DrawsWhatIsInFrontLast) {
  // By the depths of their middles, the large one would be in front of the small one.
  const Scene scene = scene_of_triangles(
      {{{{5, 5, 0}, {95, 50, 90}, {5, 95, 0}}}, {{{10, 40, 12}, {20, 50, 20}, {10, 60, 12}}}});
  EXPECT_EQ(wrong_samples(scene), 0);
  const auto layers = paint_order(scene, DepthBuffer(scene, 100, 100, 4));
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[1][0].colour, 2U);
}

TEST(PaintOrder, LeavesOutWhatIsHidden) {
  const Scene scene = scene_of_triangles(
      {{{{5, 5, 10}, {95, 50, 10}, {5, 95, 10}}}, {{{10, 40, 2}, {20, 50, 2}, {10, 60, 2}}}});
  const auto layers = paint_order(scene, DepthBuffer(scene, 100, 100, 4));
  ASSERT_EQ(count(layers), 1U);
  EXPECT_EQ(layers[0][0].colour, 1U);
}

TEST(PaintOrder, PutsNeighboursIntoOneLayer) {
  const PolyMesh grid = testing::plane_grid(20, 20);
  const Scene scene =
      testing::scene_of(grid, std::vector<Rgb>(grid.n_faces()), testing::seen_from(-60, 35));
  const auto layers = paint_order(scene, DepthBuffer(scene, 100, 100, 4));
  EXPECT_EQ(layers.size(), 1U);
  EXPECT_EQ(count(layers), 800U);
}

TEST(PaintOrder, CutsTrianglesThatPassThroughEachOther) {
  const PolyMesh mesh = testing::crossing_squares();
  const Scene scene =
      testing::scene_of(mesh, {testing::kRed, testing::kBlue}, testing::seen_from(-80, 10));
  EXPECT_LE(wrong_samples(scene), 160) << "at most along the line of the cut";
  EXPECT_LE(count(paint_order(scene, DepthBuffer(scene, 100, 100, 4))), 12U);
}

TEST(PaintOrder, CutsCirclesOfTriangles) {
  // Each lies over the next at one end, and under the one before at the other.
  std::vector<std::array<ScenePoint, 3>> bars;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.1 * i, c = std::cos(angle), s = std::sin(angle);
    const auto at = [&](double along, double across, double depth) -> ScenePoint {
      return {50 + c * along - s * across, 50 + s * along + c * across, depth};
    };
    bars.push_back({at(-40, 8, 20), at(40, 8, -20), at(-40, 16, 20)});
  }
  EXPECT_LE(wrong_samples(scene_of_triangles(bars)), 4) << "of 160,000, on the lines of the cuts";
}

}  // namespace
}  // namespace surfmesh
