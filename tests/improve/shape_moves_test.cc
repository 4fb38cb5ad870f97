// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/shape_moves.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "improve/star_of.hh"
#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {
namespace {

constexpr Metric kStretched{4, 1, 2};

/// A fan of six triangles around vertex 0, on a circle of radius 1 about the origin.
std::unique_ptr<DelaunayMesh> fan_of_six(Uv centre, const Metric& metric) {
  std::vector<Uv> points = testing::circle({0, 0}, 1, 6);
  points.insert(points.begin(), centre);
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < 6; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
  auto delaunay = std::make_unique<DelaunayMesh>(points, triangles);
  for (int i = 0; i <= 6; ++i) delaunay->metric(VertexHandle(i)) = metric;
  return delaunay;
}

TEST(SumOfInverseQualities, CountsUnitTriangles) {
  const auto delaunay = fan_of_six({0, 0}, {1, 0, 1});
  EXPECT_NEAR(sum_of_inverse_qualities(star_of(*delaunay), {{0, 0}, {1, 0, 1}}), 6, 1e-14);
}

TEST(SumOfInverseQualities, IsInfiniteWithATriangleInverted) {
  const auto delaunay = fan_of_six({0, 0}, {1, 0, 1});
  EXPECT_EQ(sum_of_inverse_qualities(star_of(*delaunay), {{1.1, 0}, {1, 0, 1}}), INFINITY);
}

TEST(ShapeStep, IsTheOneByFiniteDifferences) {
  const Star star = star_of(*fan_of_six({0, 0}, kStretched));
  const Uv at{0.2, -0.1};
  const auto f = [&](double u, double v) {
    return sum_of_inverse_qualities(star, {at + Uv{u, v}, kStretched});
  };
  const double h = 1e-4;
  const double fu = (f(h, 0) - f(-h, 0)) / (2 * h), fv = (f(0, h) - f(0, -h)) / (2 * h);
  const double fuu = (f(h, 0) - 2 * f(0, 0) + f(-h, 0)) / (h * h);
  const double fvv = (f(0, h) - 2 * f(0, 0) + f(0, -h)) / (h * h);
  const double fuv = (f(h, h) - f(h, -h) - f(-h, h) + f(-h, -h)) / (4 * h * h);
  const double determinant = fuu * fvv - fuv * fuv;
  const Uv step = shape_step(star, {at, kStretched});
  EXPECT_NEAR(step.u, (fuv * fv - fvv * fu) / determinant, 1e-5);
  EXPECT_NEAR(step.v, (fuv * fu - fuu * fv) / determinant, 1e-5);
}

TEST(ShapeMoves, LeadToTheMiddle) {
  const auto delaunay = fan_of_six({0.5, 0.3}, kStretched);
  const testing::FunctionField field = testing::constant_field(kStretched);
  ShapeMoves moves(*delaunay, field);
  int count = 0;
  while (count < 20 && moves.smooth(VertexHandle(0), 1, [](Uv) { return true; })) ++count;
  EXPECT_GT(count, 1);
  EXPECT_LT(count, 8);
  EXPECT_NEAR(delaunay->uv(VertexHandle(0)).u, 0, 0.01);
  EXPECT_NEAR(delaunay->uv(VertexHandle(0)).v, 0, 0.01);
}

TEST(ShapeMoves, GoNowhereThatIsNotAllowed) {
  const auto delaunay = fan_of_six({0.5, 0.3}, {1, 0, 1});
  const testing::FunctionField field = testing::constant_field({1, 0, 1});
  ShapeMoves moves(*delaunay, field);
  std::vector<Uv> asked;
  const auto refuse = [&](Uv uv) {
    asked.push_back(uv);
    return false;
  };
  EXPECT_FALSE(moves.smooth(VertexHandle(0), 1, refuse));
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_NEAR(asked[1].u - 0.5, 0.5 * (asked[0].u - 0.5), 1e-15);
  EXPECT_EQ(delaunay->uv(VertexHandle(0)), (Uv{0.5, 0.3}));
}

TEST(ShapeMoves, LeaveVerticesOfGoodTriangles) {
  const auto delaunay = fan_of_six({0.1, 0}, {1, 0, 1});
  const testing::FunctionField field = testing::constant_field({1, 0, 1});
  ShapeMoves moves(*delaunay, field);
  EXPECT_FALSE(moves.smooth(VertexHandle(0), 0.5, [](Uv) { return true; }));
  EXPECT_TRUE(moves.smooth(VertexHandle(0), 1, [](Uv) { return true; }));
}

TEST(SmoothShapes, RaisesTheMeanQualityAndInvertsNothing) {
  for (const testing::FunctionField& field :
       {testing::four_point_field(), testing::shock_field(10, 0.02)}) {
    const auto delaunay = testing::empty_square(field);
    refine(*delaunay, field, {});
    const double before = testing::mean_quality(*delaunay);
    smooth_shapes(*delaunay, field);
    EXPECT_GT(testing::mean_quality(*delaunay), before + 0.005);
    EXPECT_NEAR(testing::valid_area(*delaunay), 1, 1e-12);
    testing::expect_valid(delaunay->mesh());
  }
}

}  // namespace
}  // namespace surfmesh
