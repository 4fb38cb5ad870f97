// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/fit_lengths.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

/// A hexagon of radius 1 and two vertices inside, about the middle and `gap` apart.
std::unique_ptr<DelaunayMesh> hexagon_with_two(double gap) {
  std::vector<Uv> points;
  for (int i = 0; i < 6; ++i) {
    points.push_back({std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3)});
  }
  points.push_back({0, gap / 2});
  points.push_back({0, -gap / 2});
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {0, 6, 7},
                                                     {6, 3, 7}, {3, 4, 7}, {4, 5, 7}, {5, 0, 7}};
  return std::make_unique<DelaunayMesh>(points, triangles);
}

/// A rhombus of two triangles with a long diagonal, in a ring of unit triangles around it.
std::unique_ptr<DelaunayMesh> flat_rhombus(double diagonal) {
  const double height = std::numbers::sqrt3 / 2;
  const std::vector<Uv> points = {{-diagonal / 2, 0}, {diagonal / 2, 0}, {0, height}, {0, -height}};
  return std::make_unique<DelaunayMesh>(points,
                                        std::vector<std::array<int, 3>>{{0, 1, 2}, {1, 0, 3}});
}

FitReport fit(DelaunayMesh& delaunay) {
  const testing::FunctionField field = testing::isotropic_field(1);
  for (std::size_t i = 0; i < delaunay.n_vertices(); ++i) {
    delaunay.metric(VertexHandle(static_cast<int>(i))) = {1, 0, 1};
  }
  VertexMoves moves(delaunay, field);
  return fit_lengths(delaunay, moves);
}

TEST(FitLengths, CollapsesAShortEdge) {
  const auto delaunay = hexagon_with_two(0.3);
  const FitReport report = fit(*delaunay);
  EXPECT_EQ(report.collapsed, 1u);
  EXPECT_EQ(delaunay->n_vertices(), 7u);
  EXPECT_EQ(delaunay->mesh().n_faces(), 6u);
  EXPECT_NEAR(testing::least_quality(*delaunay), 1, 0.02);
  testing::expect_valid(delaunay->mesh());
}

TEST(FitLengths, SplitsALongEdge) {
  const auto delaunay = flat_rhombus(1.6);
  const FitReport report = fit(*delaunay);
  EXPECT_EQ(report.split, 1u);
  EXPECT_EQ(delaunay->n_vertices(), 5u);
  EXPECT_EQ(delaunay->mesh().n_faces(), 4u);
  testing::expect_valid(delaunay->mesh());
}

TEST(FitLengths, LeavesEdgesOfTheUnitRange) {
  const auto short_ones = hexagon_with_two(0.72);
  const auto long_ones = flat_rhombus(1.4);
  EXPECT_EQ(fit(*short_ones).collapsed, 0u);
  EXPECT_EQ(fit(*long_ones).split, 0u);
}

TEST(FitLengths, LeavesEdgesBetweenBoundaryVertices) {
  const auto delaunay = flat_rhombus(0.5);
  EXPECT_EQ(fit(*delaunay).collapsed, 0u);
  EXPECT_EQ(delaunay->n_vertices(), 4u);
}

}  // namespace
}  // namespace surfmesh
