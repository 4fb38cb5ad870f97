// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/difference_surface.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/analytic.hh"
#include "surfmesh/geometry/curvature.hh"

namespace surfmesh {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_same_curvatures(const Surface& surface, double s, double t, double tolerance) {
  const Uv uv = surface.domain().at(s, t);
  const PrincipalCurvatures exact = principal_curvatures(surface.evaluate(uv, Order::Second));
  const PrincipalCurvatures found =
      principal_curvatures(DifferenceSurface(surface).evaluate(uv, Order::Second));
  const double greatest = std::max(std::abs(exact.k1), std::abs(exact.k2));
  EXPECT_NEAR(found.k1, exact.k1, tolerance * greatest) << s << " " << t;
  EXPECT_NEAR(found.k2, exact.k2, tolerance * greatest) << s << " " << t;
}

TEST(DifferenceSurface, HasTheCurvaturesOfASphereAndATorus) {
  const test::Sphere sphere(3, {0, 2 * kPi, -1.2, 1.2});
  const test::Torus torus(3, 1, {0, 2 * kPi, 0, 2 * kPi});
  for (const double s : {0.01, 0.3, 0.77}) {
    for (const double t : {0.02, 0.5, 0.9}) {
      expect_same_curvatures(sphere, s, t, 3e-6);
      expect_same_curvatures(torus, s, t, 3e-6);
    }
  }
}

TEST(DifferenceSurface, HasNearlyTheCurvaturesOnTheBorder) {
  const test::Torus torus(3, 1, {0, 6, 0, 5, Domain::Shape::Triangle});
  for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.5}, {0.4, 0.0}}) {
    expect_same_curvatures(torus, s, t, 3e-3);
  }
}

TEST(DifferenceSurface, HasTheExactPosition) {
  const test::Sphere sphere(3, {0, 2 * kPi, -1.2, 1.2});
  EXPECT_EQ(DifferenceSurface(sphere).evaluate({1, 1.2}, Order::Second).point,
            sphere.evaluate({1, 1.2}, Order::Position).point);
}

}  // namespace
}  // namespace surfmesh
