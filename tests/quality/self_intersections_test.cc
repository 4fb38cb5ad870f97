// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/self_intersections.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using Points = std::array<Vec3, 3>;

const Points kFloor = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

TEST(PassThrough, SeesATriangleThatPierces) {
  EXPECT_TRUE(pass_through(kFloor, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 1, 1)}));
  EXPECT_TRUE(pass_through(kFloor, {Vec3(1, 1, -1), Vec3(2, 1, 1), Vec3(9, 2, 1)}));
  EXPECT_FALSE(pass_through(kFloor, {Vec3(5, 1, -1), Vec3(5, 1, 1), Vec3(6, 1, 1)}));
}

TEST(PassThrough, SeesASideThatLiesInATriangle) {
  EXPECT_TRUE(pass_through(kFloor, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 3)}));
}

TEST(PassThrough, CallsNoTouchOneOfSidesOrPoints) {
  for (const Points& touching : {
           Points{Vec3(1, 1, 0), Vec3(1, 1, 3), Vec3(2, 1, 3)},    // a corner inside
           Points{Vec3(0, 0, 0), Vec3(-1, 0, 3), Vec3(0, -1, 3)},  // a corner in common
           Points{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 0, 3)},    // a side in common
           Points{Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(1, 0, 3)},    // a piece of a side
           Points{Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(4, 4, 0)},    // in the plane, beside it
           Points{Vec3(2, -1, -1), Vec3(2, 0, 0), Vec3(2, -1, 1)}  // a corner on a side
       }) {
    EXPECT_FALSE(pass_through(kFloor, touching));
    EXPECT_FALSE(pass_through(touching, kFloor));
  }
}

TEST(PassThrough, SeesNeighboursThatCrossElsewhere) {
  // Through the corner that both have, into the triangle; and folded onto it about a side.
  EXPECT_TRUE(pass_through(kFloor, {Vec3(0, 0, 0), Vec3(2, 2, -1), Vec3(2, 2, 1)}));
  EXPECT_TRUE(pass_through(kFloor, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 0)}));
}

TEST(PassThrough, SeesTrianglesThatOverlapInAPlane) {
  EXPECT_TRUE(pass_through(kFloor, kFloor));
  EXPECT_TRUE(pass_through(kFloor, {Vec3(1, 1, 0), Vec3(1.5, 1, 0), Vec3(1, 1.5, 0)}));
  EXPECT_TRUE(pass_through(kFloor, {Vec3(-1, 1, 0), Vec3(5, 1, 0), Vec3(5, 2, 0)}));
}

TEST(PassThrough, NeedsArea) {
  EXPECT_FALSE(pass_through(kFloor, {Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 1, 1)}));
  EXPECT_FALSE(pass_through(kFloor, {Vec3(NAN, 1, -1), Vec3(1, 1, 0), Vec3(1, 2, 1)}));
}

Vec3 normal_of(const Points& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Where a triangle cuts a plane, along the direction of a line in it, with floating-point numbers.
std::pair<double, double> cut(const Points& t, const Points& plane, const Vec3& line) {
  const Vec3 normal = normal_of(plane);
  std::pair<double, double> ends(INFINITY, -INFINITY);
  const auto add = [&](const Vec3& p) {
    ends = {std::min(ends.first, line.dot(p)), std::max(ends.second, line.dot(p))};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = t[i], &q = t[(i + 1) % 3];
    const double at_p = normal.dot(p - plane[0]), at_q = normal.dot(q - plane[0]);
    if (at_p == 0) add(p);
    if (at_p * at_q < 0) add(p + at_p / (at_p - at_q) * (q - p));
  }
  return ends;
}

/// True if two corners lie in a plane. Coordinates are small integers, so this is exact.
bool has_side_in(const Points& t, const Points& plane) {
  return std::count_if(t.begin(), t.end(),
                       [&](const Vec3& p) { return normal_of(plane).dot(p - plane[0]) == 0; }) == 2;
}

/// Area of what two triangles in one plane have in common: the first cut by the sides of the other.
double common_area(const Points& a, const Points& b) {
  const Vec3 normal = normal_of(b).normalized();
  std::vector<Vec3> polygon(a.begin(), a.end());
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 inwards = normal.cross(b[(i + 1) % 3] - b[i]);
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double at_p = inwards.dot(p - b[i]), at_q = inwards.dot(q - b[i]);
      if (at_p >= 0) kept.push_back(p);
      if (at_p * at_q < 0) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = kept;
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    sum += (polygon[k - 1] - polygon[0]).cross(polygon[k] - polygon[0]);
  }
  return sum.norm();
}

/// The same by other means.
bool surely_pass_through(const Points& a, const Points& b) {
  if (normal_of(a).isZero(0) || normal_of(b).isZero(0)) return false;
  const Vec3 line = normal_of(a).cross(normal_of(b));
  if (line.isZero(0)) {
    return normal_of(a).dot(b[0] - a[0]) == 0 && common_area(a, b) > 1e-9;
  }
  if (has_side_in(a, b) && has_side_in(b, a)) return false;
  const auto [low_a, high_a] = cut(a, b, line);
  const auto [low_b, high_b] = cut(b, a, line);
  return std::min(high_a, high_b) - std::max(low_a, low_b) > 1e-9;
}

TEST(PassThrough, AgreesWithASlowerWay) {
  std::mt19937 random(1);
  for (const int size : {1, 2, 3, 6}) {
    std::uniform_int_distribution<int> coordinate(0, size);
    const auto point = [&] {
      return Vec3(coordinate(random), coordinate(random), coordinate(random));
    };
    int crossing = 0;
    for (int i = 0; i < 20000; ++i) {
      const Points a = {point(), point(), point()}, b = {point(), point(), point()};
      const bool wanted = surely_pass_through(a, b);
      crossing += wanted;
      ASSERT_EQ(pass_through(a, b), wanted) << size << ", " << i;
      ASSERT_EQ(pass_through(b, a), wanted) << size << ", " << i;
    }
    EXPECT_GT(crossing, 100);
  }
}

/// A square of n × n cells in the plane of two directions, in triangles.
void add_grid(MeshArrays& set, int n, const Vec3& origin, const Vec3& right, const Vec3& up) {
  const int first = static_cast<int>(set.points.size());
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) set.points.push_back(origin + (i * right + j * up) / n);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int v = first + j * (n + 1) + i;
      set.faces.add(std::vector{v, v + 1, v + n + 2});
      set.faces.add(std::vector{v, v + n + 2, v + n + 1});
    }
  }
}

/// Two grids that cross each other in the middle, where no vertices are.
MeshArrays crossing_grids(int n) {
  MeshArrays set;
  add_grid(set, n, {0, 0, 0}, {1, 0.1, 0.2}, {-0.1, 1, 0.3});
  add_grid(set, n, {0.513, 0.1, -0.6}, {0, 0.8, 0}, {0.01, 0, 1.5});
  return set;
}

TEST(SelfIntersections, AreNoneInAnObliquePlane) {
  MeshArrays set;
  add_grid(set, 30, {0.1, 0.2, 0.3}, {1, 0.1, 0.2}, {-0.1, 1, 0.3});
  EXPECT_EQ(find_self_intersections(set), (MeshFault{"self_intersection", 0, {}}));
}

TEST(SelfIntersections, AreTheSameAsThoseOfAllPairs) {
  const MeshArrays set = crossing_grids(7);
  const auto triangle = [&](std::size_t f) {
    const auto at = [&](std::size_t k) {
      return set.points[static_cast<std::size_t>(set.faces[f][k])];
    };
    return Points{at(0), at(1), at(2)};
  };
  std::size_t count = 0;
  for (std::size_t a = 0; a < set.faces.size(); ++a) {
    for (std::size_t b = a + 1; b < set.faces.size(); ++b) {
      count += surely_pass_through(triangle(a), triangle(b));
    }
  }
  EXPECT_GT(count, 10u);
  EXPECT_EQ(find_self_intersections(set).count, count);
}

TEST(SelfIntersections, TellFacesPatchesAndPlace) {
  MeshArrays set;
  set.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 2, -1}, {1, 2, 1}, {9, 2, 1}};
  set.faces.add(std::vector{0, 1, 2, 3});
  set.faces.add(std::vector{4, 5, 6});
  set.patches = {0, 1};
  set.names.patches = {"floor", "wing"};
  EXPECT_EQ(find_self_intersections(set),
            (MeshFault{"self_intersection",
                       1,  // the square is two triangles, but one face
                       {"faces 0 of patch floor and 1 of patch wing near (2.5, 2, 0)"}}));
}

TEST(SelfIntersections, DoNotDependOnTheThreads) {
  const MeshArrays set = crossing_grids(60);
  MeshFault one, many;
  with_threads(1, [&] { one = find_self_intersections(set); });
  with_threads(4, [&] { many = find_self_intersections(set); });
  EXPECT_GT(one.count, MeshFault::kMostPlaces);
  EXPECT_EQ(one.places.size(), MeshFault::kMostPlaces);
  EXPECT_EQ(one, many);
}

TEST(SelfIntersections, EndOnceTheyAreCancelled) {
  testing::Cancelling observer;
  const RunContext context(&observer);
  EXPECT_EQ(error_of([&] { find_self_intersections(crossing_grids(3), context); }),
            testing::kCancelled);
}

}  // namespace
}  // namespace surfmesh
