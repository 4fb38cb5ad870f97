// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/surface_search.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "support/models.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

TEST(FindNearPoint, FindsTheFootOnASphere) {
  const auto sphere = testing::sphere();
  for (const double radius : {0.3, 0.99, 1.0, 1.7}) {
    const Vec3 point = radius * Vec3(0.48, 0.6, 0.64);
    const NearPoint near = find_near_point(*sphere, point, {1.2, 0.4});
    EXPECT_NEAR(near.distance, std::abs(radius - 1), 1e-12);
    EXPECT_NEAR(near.uv.u, std::atan2(0.6, 0.48), 1e-6);
    EXPECT_NEAR(near.uv.v, std::asin(0.64), 1e-6);
    EXPECT_FALSE(near.is_on_border);
  }
}

TEST(FindNearPoint, EndsWhereItIsNearEnough) {
  const NearPoint near = find_near_point(*testing::sphere(), {2, 0, 0}, {0.5, 0.3}, {1.05, 0});
  EXPECT_LE(near.distance, 1.05);
  EXPECT_GT(near.distance, 1 + 1e-6);
}

TEST(FindNearPoint, EndsWhereItIsAccurateEnough) {
  int count = 0;
  const auto bowl = make_callable_surface({-1, 1, -1, 1}, [&count](auto u, auto v) {
    ++count;
    return std::array{u, v, u * u + 2 * v * v};
  });
  const Vec3 point(0.3, 0.2, 0.4);
  const double exact = find_near_point(*bowl, point, {0.3, 0.2}).distance;
  const int exact_count = std::exchange(count, 0);
  const double distance = find_near_point(*bowl, point, {0.3, 0.2}, {.accuracy = 1e-4}).distance;
  EXPECT_NEAR(distance, exact, 2e-4 * exact);
  EXPECT_LE(2 * count, exact_count);
}

TEST(FindNearPoint, GoesIntoPoles) {
  const NearPoint near = find_near_point(*testing::sphere(), {0, 0, 1.5}, {1, 1.1});
  EXPECT_NEAR(near.distance, 0.5, 1e-12);
  EXPECT_NEAR(near.uv.v, pi / 2, 1e-6);
}

TEST(FindNearPoint, SlidesAlongTheBorder) {
  const auto plane = testing::rectangle(0, 0, 1, 1);
  const NearPoint side = find_near_point(*plane, {2, 0.7, 0}, {0.2, 0.1});
  EXPECT_NEAR(side.distance, 1, 1e-12);
  EXPECT_NEAR(side.uv.v, 0.7, 1e-9);
  EXPECT_TRUE(side.is_on_border);
  const NearPoint corner = find_near_point(*plane, {2, -1, 0}, {0.2, 0.5});
  EXPECT_NEAR(corner.distance, std::sqrt(2), 1e-12);
}

TEST(FindNearPoint, SlidesAlongTheDiagonalOfATriangle) {
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                               Domain{0, 1, 0, 1, Domain::Shape::Triangle});
  const NearPoint near = find_near_point(plane, {1, 1, 0}, {0.8, 0.1});
  EXPECT_NEAR(near.distance, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(near.uv.u, 0.5, 1e-9);
}

TEST(FindNearPoint, StaysOnItsSideOfASeam) {
  const auto torus = testing::whole_torus();
  const Vec3 point = torus->evaluate({0, 1}, Order::Position).point;
  EXPECT_NEAR(find_near_point(*torus, point, {0.1, 1}).uv.u, 0, 1e-9);
  EXPECT_NEAR(find_near_point(*torus, point, {2 * pi - 0.1, 1}).uv.u, 2 * pi, 1e-9);
}

TEST(SurfaceSearch, FindsPointsOfATorusFromAside) {
  const Model model = testing::model_of({testing::whole_torus()});
  const SurfaceSearch search(model);
  for (int i = 0; i < 200; ++i) {
    const double u = std::fmod(0.7548776662 * i, 1) * 2 * pi,
                 v = std::fmod(0.569840291 * i, 1) * 2 * pi;
    const Jet jet = model.patches[0].surface->evaluate({u, v}, Order::First);
    const Vec3 normal = jet.du.cross(jet.dv).normalized();
    EXPECT_NEAR(search.nearest(jet.point + 0.1 * normal).distance, 0.1, 1e-9);
  }
}

TEST(SurfaceSearch, LooksAtAllPatchesOrAtSome) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const SurfaceSearch search(model);
  const Vec3 point(1.3, 0.5, 0.2);
  EXPECT_EQ(search.nearest(point).patch, 1);
  EXPECT_NEAR(search.nearest(point).distance, 0.2, 1e-12);
  EXPECT_EQ(search.nearest(point, {0}).patch, 0);
  EXPECT_NEAR(search.nearest(point, {0}).distance, std::hypot(0.3, 0.2), 1e-12);
}

/// A strip, whose samples are far apart, with a patch beside it and a small one close above it.
TEST(SurfaceSearch, LooksAroundPatchesThatAreKnownToBeNear) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 10, 0.01), testing::rectangle(0, 0.01, 10, 1),
                         testing::plane({4.98, -0.045, 0.001}, {0.1, 0, 0}, {0, 0.1, 0})});
  const SurfaceSearch search(model);
  const Vec3 point(5.03, 0.004, 0);
  const std::vector<int> beside = {1};
  ASSERT_EQ(search.nearest(point).patch, 2);
  EXPECT_EQ(search.nearest_around(point, {}, 1e-9).patch, 2);
  const NearPoint found = search.nearest_around(point, beside, 1e-9);
  EXPECT_EQ(found.patch, 0);
  EXPECT_NEAR(found.distance, 0, 1e-12);
  EXPECT_EQ(search.nearest_around(point, beside, 0.01).patch, 2);  // near enough
}

}  // namespace
}  // namespace surfmesh
