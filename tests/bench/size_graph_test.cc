// SPDX-License-Identifier: BSD-3-Clause
#include "bench/size_graph.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh::judge {
namespace {

constexpr int kSide = 61;
constexpr double kStep = 0.1;

/// A point of the plane z = 0 in a frame turned by an angle.
SizedPoint plane_point(double x, double y, const SizeTensor& size, double angle = 0) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{Vec3(x, y, 0), Vec3(c, s, 0), Vec3(-s, c, 0)}, size};
}

/// A square of large sizes, with another size in its middle.
std::vector<SizedPoint> square_with(const SizeTensor& middle) {
  std::vector<SizedPoint> points;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const int half = kSide / 2;
      const SizeTensor size = i == half && j == half ? middle : isotropic(100);
      points.push_back(plane_point(kStep * (i - half), kStep * (j - half), size));
    }
  }
  return points;
}

TEST(SizeGraph, GrowsWithTheDistanceInAllDirections) {
  const double grade = 1.5, least = 0.05;
  const auto points = square_with(isotropic(least));
  SizeGraph graph;
  graph.add_grid(kSide, kSide, points);
  graph.grade(grade);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double growth = std::log(grade) * points[i].frame.point.norm();
    EXPECT_GE(graph.size(i).h11, (least + growth) * (1 - 1e-3));
    EXPECT_LE(graph.size(i).h11, (least + 1.0132 * growth) * (1 + 1e-3));
    EXPECT_NEAR(graph.size(i).h12, 0, 1e-6);
  }
}

TEST(SizeGraph, GrowsFasterTheShorterTheSizeOnTheWay) {
  SizeGraph graph;
  graph.add_grid(kSide, kSide, square_with(size_tensor(0.2, 0.1, 0)));
  graph.grade(1.5);
  // Two units along x are ten lengths there, twenty along y.
  const std::size_t middle = kSide * kSide / 2;
  const auto steps = static_cast<std::size_t>(std::lround(2 / kStep));
  EXPECT_NEAR(graph.size(middle + steps).h11, 0.2 + 2 * std::log(1.5), 0.01);
  EXPECT_NEAR(graph.size(middle + steps * kSide).h22, 0.1 + 2 * std::log(1.5), 0.01);
}

TEST(SizeGraph, KeepsTheAngleFromTheFirstAxisWithinAPatch) {
  SizeGraph graph;
  const SizeTensor size = size_tensor(0.2, 0.1, 0.5);
  const std::size_t a = graph.add_point(plane_point(0, 0, size));
  const std::size_t b = graph.add_point(plane_point(0, 0, isotropic(1), 0.3));
  graph.link(a, b);
  graph.grade(1.5);
  EXPECT_EQ(graph.size(b), size);
}

TEST(SizeGraph, UnfoldsPatchesAroundTheirContour) {
  // The contour is along x of the first patch, which is on its left, and along y of the second.
  for (const bool is_mirrored : {false, true}) {
    SizeGraph graph;
    const std::size_t a = graph.add_point(plane_point(0, 0, size_tensor(0.2, 0.1, 0.3)));
    const std::size_t b = graph.add_point(plane_point(0, 0, isotropic(1)));
    graph.link_across({a, 1, 0, true}, {b, 0, 1, is_mirrored});
    graph.grade(1.5);
    const double angle = is_mirrored ? -0.3 : 0.3;
    const double expected = std::remainder(angle + 0.5 * std::numbers::pi, std::numbers::pi);
    EXPECT_NEAR(principal_sizes(graph.size(b)).angle, expected, 1e-9);
  }
}

TEST(SizeGraph, KeepsTheLeastSizeAroundTheTipOfACone) {
  SizeGraph graph;
  std::vector<std::size_t> points;
  for (int i = 0; i < 3; ++i) {
    points.push_back(graph.add_point(plane_point(0, 0, size_tensor(0.2, 0.1, 0.4 * i))));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    graph.link_across({points[i], 1, 0, true}, {points[(i + 1) % 3], 0.6, 0.8, false});
  }
  graph.grade(1.5);
  for (const std::size_t i : points) EXPECT_NEAR(principal_sizes(graph.size(i)).l_t, 0.1, 1e-9);
}

TEST(SizeGraph, KeepsTheLeastSizeWhereStretchedSizesTurn) {
  // Across a circle a hundred times longer than along it, in frames that do not turn.
  SizeGraph graph;
  std::vector<SizedPoint> points;
  for (int i = 0; i < kSide; ++i) {
    const double angle = 3.0 * i / kSide;
    points.push_back(plane_point(std::cos(angle), std::sin(angle), size_tensor(10, 0.1, angle)));
  }
  graph.add_grid(kSide, 1, points);
  graph.grade(1.5);
  for (std::size_t i = 0; i < kSide; ++i) {
    EXPECT_NEAR(principal_sizes(graph.size(i)).l_t, 0.1, 1e-9);
  }
}

TEST(SizeGraph, LeavesSizesWithoutGradation) {
  SizeGraph graph;
  const std::size_t a = graph.add_point(plane_point(0, 0, isotropic(0.1)));
  const std::size_t b = graph.add_point(plane_point(0, 0, isotropic(1)));
  graph.link(a, b);
  graph.grade(0);
  EXPECT_EQ(graph.size(b), isotropic(1));
}

}  // namespace
}  // namespace surfmesh::judge
