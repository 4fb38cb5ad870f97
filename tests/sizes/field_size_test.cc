// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/field_size.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using Formulas = std::array<std::string, 3>;

const test::PlanePatch kSkewPlane(Vec3::Zero(), {2, 0, 0}, {1, 3, 0});
const test::Sphere kSphere(2, {0, 2 * pi, -pi / 2, pi / 2});

/// Bounds in random boxes are below the lengths there, and approach the least of them.
void expect_bounds(const FieldSource& field, const Surface& surface, double excess) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const Domain domain = surface.domain();
  for (int i = 0; i < 300; ++i) {
    const double width = std::pow(10, -4 * share(random));
    const double s = (1 - width) * share(random), t = 0.05 + (0.9 - 0.9 * width) * share(random);
    const Uv from = domain.at(s, t), to = domain.at(s + width, t + 0.9 * width);
    const double bound = least_length_in(field, surface, {{from.u, to.u}, {from.v, to.v}});
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 100; ++k) {
      const Uv uv = {std::lerp(from.u, to.u, k % 10 / 9.0), std::lerp(from.v, to.v, k / 10 / 9.0)};
      least = std::min(least, least_length(field, surface, uv));
    }
    EXPECT_LE(bound, least * (1 + 1e-12));
    EXPECT_GE(bound, least * (1 - excess * width)) << "width " << width;
  }
}

TEST(FieldSize, IsBoundedInParameters) {
  expect_bounds(formula_field("1+0.5*sin(3*u)+v"), kSkewPlane, 3);
}

TEST(FieldSize, IsBoundedInSpace) {
  expect_bounds(formula_field("3+x+0.5*y*z"), kSkewPlane, 30);
  expect_bounds(formula_field("4+x+z"), kSphere, 30);
}

TEST(FieldSize, OfAMetricIsBounded) {
  expect_bounds(formula_field(Formulas{"4+u", "0.5*v", "9+v*u"}), kSkewPlane, 3);
  expect_bounds(formula_field(Formulas{"cos(v)^2", "0.1*cos(v)", "4+sin(u)"}), kSphere, 60);
}

TEST(FieldSize, OfAConstantMetricOnAPlaneIsKnownExactly) {
  const FieldSource field = formula_field(Formulas{"400", "30", "25"});
  const double bound = least_length_in(field, kSkewPlane, {{0, 1}, {0, 1}});
  EXPECT_NEAR(bound, least_length(field, kSkewPlane, {0.3, 0.2}), 1e-14);
}

TEST(FieldSize, AtAPoleIsSampledInSmallBoxes) {
  const FieldSource field = formula_field(Formulas{"cos(v)^2*25", "0", "25"});
  EXPECT_EQ(least_length_in(field, kSphere, {{0, 1}, {1, pi / 2}}), 0);
  EXPECT_NEAR(least_length_in(field, kSphere, {{0, 0.05}, {1.55, pi / 2}}), 0.4, 1e-6);
}

TEST(FieldSize, DoesNotEvaluateASurfaceThatItDoesNotUse) {
  class Unused : public test::PlanePatch {
   public:
    using PlanePatch::PlanePatch;
    Jet evaluate(Uv, Order) const override { throw Error(ErrorCode::Geometry, "evaluated"); }
  };
  const Unused surface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  EXPECT_EQ(least_length_in(formula_field("1+u"), surface, {{0, 1}, {0, 1}}), 1);
  EXPECT_EQ(least_length(formula_field("1+u"), surface, {1, 0}), 2);
  EXPECT_EQ(error_of([&] {
              least_length(formula_field("1+x"), surface, {0, 0});
            }),
            "geometry: evaluated");
}

}  // namespace
}  // namespace surfmesh
