// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/curvature.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/geometry/first_form.hh"

namespace surfmesh {
namespace {

using Constants = std::map<std::string, double>;

constexpr Domain kWideDomain{-10, 10, -10, 10};

PrincipalCurvatures at(const SurfaceFormulas& formulas, Uv uv) {
  return principal_curvatures(FormulaSurface(formulas, kWideDomain).evaluate(uv, Order::Second));
}

/// Unit vector of the k1 direction in space, in the frame whose first axis is along p_u.
Vec3 direction(const Jet& jet, double angle) {
  const Vec3 first = jet.du.normalized();
  const Vec3 second = jet.du.cross(jet.dv).normalized().cross(first);
  return std::cos(angle) * first + std::sin(angle) * second;
}

TEST(FirstForm, FactorTimesItsTransposeIsTheForm) {
  const Vec3 du(1, 2, -0.5), dv(0.3, -1, 2);
  const FirstFormFactor p = first_form_factor(du, dv);
  EXPECT_NEAR(p.l11 * p.l11, du.dot(du), 1e-14);
  EXPECT_NEAR(p.l11 * p.l21, du.dot(dv), 1e-14);
  EXPECT_NEAR(p.l21 * p.l21 + p.l22 * p.l22, dv.dot(dv), 1e-14);
}

TEST(FirstForm, IsRegularUnlessDerivativesVanishOrAreParallel) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), zero = Vec3::Zero();
  EXPECT_TRUE(is_regular(first_form_factor(x, y)));
  EXPECT_TRUE(is_regular(first_form_factor(1e-30 * x, 1e30 * y)));
  EXPECT_TRUE(is_regular(first_form_factor(x, x + 1e-9 * y)));
  EXPECT_FALSE(is_regular(first_form_factor(zero, y)));
  EXPECT_FALSE(is_regular(first_form_factor(x, zero)));
  EXPECT_FALSE(is_regular(first_form_factor(zero, zero)));
  EXPECT_FALSE(is_regular(first_form_factor(x, -3 * x)));
  EXPECT_FALSE(is_regular(first_form_factor(x, x + 1e-14 * y)));
  EXPECT_FALSE(is_regular(FirstFormFactor()));
}

TEST(Curvature, OfTheSphereIsOneOverTheRadius) {
  const SurfaceFormulas sphere{"2*cos(u)*cos(v)", "2*sin(u)*cos(v)", "2*sin(v)"};
  for (double v = -1.5; v <= 1.5; v += 0.25) {
    const PrincipalCurvatures k = at(sphere, {0.4, v});
    EXPECT_NEAR(k.k1, -0.5, 1e-14);
    EXPECT_NEAR(k.k2, -0.5, 1e-14);
    EXPECT_TRUE(std::isfinite(k.angle()));
  }
}

TEST(Curvature, OfTheCylinderIsAcrossItsAxis) {
  // Outward normal: the surface bends away from it.
  const PrincipalCurvatures k = at({"2*cos(u)", "2*sin(u)", "v"}, {0.4, 3});
  EXPECT_NEAR(k.k1, 0, 1e-15);
  EXPECT_NEAR(k.k2, -0.5, 1e-15);
  EXPECT_NEAR(std::abs(k.angle()), std::numbers::pi / 2, 1e-15);
}

TEST(Curvature, OfTheTorusIsThatOfItsCircles) {
  const SurfaceFormulas torus{"(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"};
  for (double v = -3; v <= 3; v += 0.5) {
    const PrincipalCurvatures k = at(torus, {0.4, v});
    EXPECT_NEAR(k.k1, -std::cos(v) / (3 + std::cos(v)), 1e-14);
    EXPECT_NEAR(k.k2, -1, 1e-14);
    EXPECT_NEAR(k.angle(), 0, 1e-14);
  }
}

TEST(Curvature, OfTheSaddleIsAlongItsRulingsBisectors) {
  const PrincipalCurvatures k = at({"u", "v", "u*v"}, {0, 0});
  EXPECT_EQ(k.k1, 1);
  EXPECT_EQ(k.k2, -1);
  EXPECT_NEAR(k.angle(), std::numbers::pi / 4, 1e-15);
}

TEST(Curvature, DoesNotDependOnTheParameters) {
  // The saddle z = (x² − 2y²)/2 at its middle, through skew and unequal parameters.
  const SurfaceFormulas skew{"3*u+v", "0.1*v", "((3*u+v)^2-2*(0.1*v)^2)/2"};
  const Jet jet = FormulaSurface(skew, kWideDomain).evaluate({0, 0}, Order::Second);
  const PrincipalCurvatures k = principal_curvatures(jet);
  EXPECT_NEAR(k.k1, 1, 1e-13);
  EXPECT_NEAR(k.k2, -2, 1e-13);
  EXPECT_NEAR(std::abs(direction(jet, k.angle()).x()), 1, 1e-13);
}

TEST(Curvature, LosesDigitsByTheSquareOfTheSine) {
  for (double sine : {1.0, 1e-1, 1e-2, 1e-3, 1e-4}) {
    const Constants constants = {{"c", std::sqrt(1 - sine * sine)}, {"s", sine}};
    const FormulaSurface skew({"u+c*v", "s*v", "((u+c*v)^2-0.7*(s*v)^2)/2"}, kWideDomain,
                              constants);
    const Jet jet = skew.evaluate({0, 0}, Order::Second);
    const PrincipalCurvatures k = principal_curvatures(jet);
    EXPECT_NEAR(k.k1, 1, 1e-14 / (sine * sine)) << sine;
    EXPECT_NEAR(k.k2, -0.7, 1e-14 / (sine * sine)) << sine;
  }
}

TEST(Curvature, ChangesSignWithTheNormal) {
  const PrincipalCurvatures k = at({"u", "v", "u^2+3*v^2+u*v"}, {0.3, 0.2});
  const PrincipalCurvatures mirrored = at({"v", "u", "v^2+3*u^2+u*v"}, {0.2, 0.3});
  EXPECT_NEAR(mirrored.k1, -k.k2, 1e-14);
  EXPECT_NEAR(mirrored.k2, -k.k1, 1e-14);
}

// Absolute principal curvatures and cosine and sine of the angle, from
// `CurvatureSurface(c=1, hmin=0, hmax=1e300, stretch=1e300).curvature_sizes(u, v)` of the benchmark
// scripts: 1/h1, 1/h2, and the first covector over its first entry.
TEST(Curvature, OfTheWaveIsThatOfTheReference) {
  struct Reference {
    Uv at;
    double k1, k2, cosine, sine;
  };
  const Reference references[] = {
      {{0.5, -1},
       0.026915261890390896,
       0.75480256937858692,
       0.072390690598472571,
       0.99737635219343168},
      {{-1.25, 0.75},
       0.2081911247203117,
       0.013689992982813771,
       0.99627755442719845,
       0.086203448565359941},
      {{6, 6}, 0.62295409068074592, 0.10164180938736911, 0.88342244395764802, -0.46857740610479309},
  };
  const SurfaceFormulas wave{"u", "v", "1.5*sin(2*u)*cos(v/5)*exp(-(u^2+v^2)/1000)"};
  for (const Reference& r : references) {
    const PrincipalCurvatures k = at(wave, r.at);
    EXPECT_NEAR(std::abs(k.k1), r.k1, 1e-14 * (1 + r.k1));
    EXPECT_NEAR(std::abs(k.k2), r.k2, 1e-14 * (1 + r.k2));
    EXPECT_NEAR(std::cos(k.angle()), r.cosine, 1e-13);
    EXPECT_NEAR(std::sin(k.angle()), r.sine, 1e-13);
  }
}

TEST(Curvature, DirectionIsWhereTheNormalCurvatureIsGreatest) {
  const FormulaSurface surface({"u+0.2*v^2", "v-0.1*u*v", "sin(u)*cos(2*v)"}, kWideDomain);
  const Jet jet = surface.evaluate({0.4, 0.3}, Order::Second);
  const PrincipalCurvatures k = principal_curvatures(jet);
  const FirstFormFactor p = first_form_factor(jet.du, jet.dv);
  const Vec3 normal = jet.du.cross(jet.dv).normalized();
  const auto normal_curvature = [&](double angle) {
    // The parameter step e of the unit tangent (cos, sin): L^T e = (cos, sin).
    const double v = std::sin(angle) / p.l22;
    const double u = (std::cos(angle) - p.l21 * v) / p.l11;
    return (jet.duu * u * u + jet.duv * 2 * u * v + jet.dvv * v * v).dot(normal);
  };
  EXPECT_NEAR(normal_curvature(k.angle()), k.k1, 1e-14);
  EXPECT_NEAR(normal_curvature(k.angle() + std::numbers::pi / 2), k.k2, 1e-14);
  for (double angle = 0; angle < 3.2; angle += 0.1) {
    EXPECT_LE(normal_curvature(angle), k.k1 + 1e-14);
    EXPECT_GE(normal_curvature(angle), k.k2 - 1e-14);
  }
}

TEST(Curvature, AtAnUmbilicIsEqualAndTheAngleFinite) {
  const PrincipalCurvatures bowl = at({"u", "v", "(u^2+v^2)/2"}, {0, 0});
  EXPECT_EQ(bowl.k1, 1);
  EXPECT_EQ(bowl.k2, 1);
  EXPECT_TRUE(std::isfinite(bowl.angle()));
  const PrincipalCurvatures plane = at({"u", "v", "0"}, {1, 2});
  EXPECT_EQ(plane.k1, 0);
  EXPECT_EQ(plane.k2, 0);
  EXPECT_TRUE(std::isfinite(plane.angle()));
}

TEST(Curvature, IsUnsetWithoutATangentPlane) {
  const SurfaceFormulas cone{"v*cos(u)", "v*sin(u)", "v"};
  const PrincipalCurvatures apex = at(cone, {0.3, 0});
  EXPECT_TRUE(std::isnan(apex.k1) && std::isnan(apex.k2) && std::isnan(apex.angle()));
  EXPECT_TRUE(std::isnan(at({"u", "v^2", "0"}, {0.3, 0}).k1));
  EXPECT_TRUE(std::isnan(at({"u+v", "u+v", "0"}, {0.3, 0}).k1));
}

TEST(Curvature, IsRightBesideAPole) {
  const SurfaceFormulas sphere{"2*cos(u)*cos(v)", "2*sin(u)*cos(v)", "2*sin(v)"};
  for (double distance : {1e-3, 1e-8, 1e-13}) {
    const PrincipalCurvatures k = at(sphere, {0.4, std::numbers::pi / 2 - distance});
    EXPECT_NEAR(k.k1, -0.5, 1e-12);
    EXPECT_NEAR(k.k2, -0.5, 1e-12);
  }
}

}  // namespace
}  // namespace surfmesh
