// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_to_surface.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/analytic.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

const test::Torus kTorus(2, 0.5, {0, 2 * pi, 0, 2 * pi});
const test::Sphere kSphere(1, {0, 2 * pi, -pi / 2, pi / 2});

TEST(ProjectToSurface, FindsPointsOnTheSurface) {
  for (const Uv uv : {Uv{1, 2}, Uv{3, 5}, Uv{0.1, 6.2}}) {
    const Vec3 point = kTorus.evaluate(uv, Order::Position).point;
    const SurfaceFoot foot = project_to_surface(kTorus, point, uv + Uv{0.2, -0.1});
    EXPECT_NEAR(foot.uv.u, uv.u, 1e-14);
    EXPECT_NEAR(foot.uv.v, uv.v, 1e-14);
    EXPECT_LE(foot.distance, 1e-15);
  }
}

TEST(ProjectToSurface, FindsTheFootOfAPointAside) {
  const SurfaceFoot foot = project_to_surface(kSphere, 1.2 * Vec3(0, 0.6, 0.8), {1.2, 0.5});
  EXPECT_NEAR(foot.uv.u, pi / 2, 1e-9);
  EXPECT_NEAR(foot.uv.v, std::asin(0.8), 1e-9);
  EXPECT_NEAR(foot.distance, 0.2, 1e-15);
}

TEST(ProjectToSurface, StaysInTheDomain) {
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3(0.5, 1, 0));
  const SurfaceFoot foot = project_to_surface(plane, {3, 0.4, 0}, {0.5, 0.5});
  EXPECT_EQ(foot.uv.u, 1);
  EXPECT_LE(foot.uv.v, 1);
}

TEST(ProjectToSurface, KeepsTheFreeParameterAtAPole) {
  const SurfaceFoot foot = project_to_surface(kSphere, {0, 0, 1}, {2, 1.4});
  EXPECT_NEAR(foot.uv.u, 2, 1e-9);
  EXPECT_NEAR(foot.uv.v, pi / 2, 1e-9);
}

TEST(NearPlaces, FindBothSidesOfASeam) {
  const auto places = find_near_points(kTorus, kTorus.evaluate({0, 1}, Order::Position).point);
  ASSERT_GE(places.size(), 2u);
  EXPECT_LE(places[1].distance, 1e-14);
  EXPECT_NEAR(std::abs(places[0].uv.u - places[1].uv.u), 2 * pi, 1e-12);
}

}  // namespace
}  // namespace surfmesh
