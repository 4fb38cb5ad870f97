// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/project_curve.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "support/analytic.hh"
#include "support/errors.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using Shape = std::shared_ptr<const Surface>;

constexpr double kReach = 1e-6;

const Shape kCylinder = std::make_shared<test::Cylinder>(1, Domain{0, 2 * pi, 0, 3});

std::shared_ptr<const SpaceCurve> in_space(std::function<Vec3(double)> function) {
  return std::make_shared<CallableSpaceCurve>(std::move(function));
}

std::shared_ptr<const SpaceCurve> on_surface(const Shape& shape, std::function<Uv(double)> curve) {
  return std::make_shared<CurveOnSurface>(shape, std::make_shared<CallableCurve>(curve));
}

TEST(ProjectCurve, FindsTheCurveThatItWasMadeFrom) {
  const auto truth = [](double t) {
    return Uv{3 + 2 * std::cos(2 * pi * t), 1.5 + std::sin(2 * pi * t)};
  };
  const auto curve = project_curve(kCylinder, on_surface(kCylinder, truth), kReach);
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    EXPECT_NEAR(curve->evaluate(t).u, truth(t).u, 1e-13);
    EXPECT_NEAR(curve->evaluate(t).v, truth(t).v, 1e-13);
  }
}

TEST(ProjectCurve, StartsOnTheRightSideOfASeam) {
  for (const double direction : {1.0, -1.0}) {
    const auto circle = in_space(
        [=](double t) { return Vec3(std::cos(2 * pi * t), direction * std::sin(2 * pi * t), 1); });
    const auto curve = project_curve(kCylinder, circle, kReach);
    EXPECT_NEAR(curve->evaluate(0).u, direction > 0 ? 0 : 2 * pi, 1e-13);
    EXPECT_NEAR(curve->evaluate(1).u, direction > 0 ? 2 * pi : 0, 1e-13);
  }
}

TEST(ProjectCurve, IsSmoothUnderStrongStretch) {
  const auto surface = std::make_shared<test::Reparametrised>(kCylinder);
  const auto line =
      in_space([](double t) { return Vec3(std::cos(4 * t), std::sin(4 * t), 3 * t); });
  const auto curve = project_curve(surface, line, kReach);
  const double h = 1e-4;
  for (double t = 2 * h; t < 1 - 2 * h; t += 0.01) {
    const auto u = [&](double x) { return curve->evaluate(x).u; };
    const double second = (u(t + h) - 2 * u(t) + u(t - h)) / (h * h);
    const double shifted = (u(t + 2 * h) - 2 * u(t + h) + u(t)) / (h * h);
    EXPECT_NEAR(second, shifted, 0.05);
  }
}

TEST(ProjectCurve, EndsAtAPole) {
  const auto sphere = std::make_shared<test::Sphere>(1, Domain{0, 2 * pi, -pi / 2, pi / 2});
  const auto arc = in_space([](double t) { return Vec3(0, std::cos(1.5 * t), std::sin(1.5 * t)); });
  const auto to_pole =
      in_space([](double t) { return Vec3(0, std::cos(pi / 2 * t), std::sin(pi / 2 * t)); });
  EXPECT_NEAR(project_curve(sphere, arc, kReach)->evaluate(1).v, 1.5, 1e-12);
  const Uv end = project_curve(sphere, to_pole, kReach)->evaluate(1);
  EXPECT_NEAR(end.u, pi / 2, 1e-6);
  EXPECT_NEAR(end.v, pi / 2, 1e-6);
}

TEST(ProjectCurve, FollowsKinks) {
  const auto kink = on_surface(kCylinder, [](double t) { return Uv{1 + t, std::abs(t - 0.3)}; });
  EXPECT_NEAR(project_curve(kCylinder, kink, kReach)->evaluate(0.3).v, 0, 1e-12);
}

TEST(ProjectCurve, TellsTheGapOfACurveThatIsOffTheSurface) {
  const auto circle = in_space([](double t) -> Vec3 {
    return (1 + 0.1 * t) * Vec3(std::cos(2 * t), std::sin(2 * t), 0) + Vec3(0, 0, 1);
  });
  EXPECT_EQ(error_of([&] {
              project_curve(kCylinder, circle, kReach, {0, 10});
            }),
            "geometry: its distance from the patch at t = 10 is 0.1, which must be below 1e-06");
}

TEST(ProjectCurve, TellsWhereItLeavesTheDomain) {
  const auto arc =
      in_space([](double t) { return Vec3(std::cos(4 * t - 2), std::sin(4 * t - 2), 1); });
  const std::string error = error_of([&] { project_curve(kCylinder, arc, kReach); });
  EXPECT_NE(error.find("it leaves the domain at t = 0.5"), std::string::npos) << error;
}

}  // namespace
}  // namespace surfmesh
