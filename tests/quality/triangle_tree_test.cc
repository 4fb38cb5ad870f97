// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/triangle_tree.hh"

#include <gtest/gtest.h>

#include <random>

#include "surfmesh/quality/triangle_distance.hh"

namespace surfmesh {
namespace {

/// Triangles of random corners, some of which are the same or on a line.
Facets random_facets(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Facets facets;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 a(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 b = a + 0.2 * Vec3(coordinate(random), coordinate(random), coordinate(random));
    const Vec3 c = a + 0.2 * Vec3(coordinate(random), coordinate(random), coordinate(random));
    const int first = static_cast<int>(facets.points.size());
    facets.points.insert(facets.points.end(),
                         {a, t % 7 == 0 ? a : b, t % 5 == 0 ? Vec3(0.3 * a + 0.7 * b) : c});
    facets.triangles.push_back({first, first + 1, first + 2});
    facets.faces.push_back(static_cast<int>(t));
  }
  return facets;
}

double distance_from_all(const Facets& facets, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : facets.triangles) {
    const auto corner = [&](std::size_t i) {
      return facets.points[static_cast<std::size_t>(t[i])];
    };
    least = std::min(least,
                     detail::triangle_distance(point, {corner(0), corner(1), corner(2)}).distance);
  }
  return least;
}

TEST(TriangleTree, FindsTheNearestOfAll) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (const std::size_t count : {1u, 4u, 5u, 300u}) {
    const Facets facets = random_facets(random, count);
    const TriangleTree tree(facets);
    for (int i = 0; i < 300; ++i) {
      const Vec3 point(coordinate(random), coordinate(random), coordinate(random));
      const TriangleTree::Nearest nearest = tree.nearest(point, static_cast<std::size_t>(i));
      EXPECT_NEAR(nearest.distance, distance_from_all(facets, point), 1e-12);
      Facets one = facets;
      one.triangles = {facets.triangles[nearest.triangle]};
      EXPECT_NEAR(nearest.distance, distance_from_all(one, point), 1e-12);
    }
  }
}

TEST(TriangleTree, IsAtPointsOfItsTriangles) {
  std::mt19937 random(3);
  const Facets facets = random_facets(random, 50);
  const TriangleTree tree(facets);
  for (const Vec3& point : facets.points) EXPECT_LE(tree.nearest(point).distance, 1e-15);
}

}  // namespace
}  // namespace surfmesh
