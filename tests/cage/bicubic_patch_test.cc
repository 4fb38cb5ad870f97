// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/bicubic_patch.hh"

#include <gtest/gtest.h>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// x = u³ v³ - 2 u² v, y = u v² + 3, z = 1 - u³ + v³ with all derivatives.
Jet bicubic_polynomial(Uv p) {
  const double u = p.u, v = p.v;
  Jet jet;
  jet.point = {u * u * u * v * v * v - 2 * u * u * v, u * v * v + 3, 1 - u * u * u + v * v * v};
  jet.du = {3 * u * u * v * v * v - 4 * u * v, v * v, -3 * u * u};
  jet.dv = {3 * u * u * u * v * v - 2 * u * u, 2 * u * v, 3 * v * v};
  jet.duu = {6 * u * v * v * v - 4 * v, 0, -6 * u};
  jet.duv = {9 * u * u * v * v - 4 * u, 2 * v, 0};
  jet.dvv = {6 * u * u * u * v, 2 * u, 6 * v};
  return jet;
}

std::shared_ptr<const Surface> polynomial_patch() {
  const Domain domain;
  return make_bicubic_patch(
      {bicubic_polynomial(domain.corner(0)), bicubic_polynomial(domain.corner(1)),
       bicubic_polynomial(domain.corner(2)), bicubic_polynomial(domain.corner(3))});
}

TEST(BicubicPatchTest, ReproducesABicubicPolynomial) {
  const auto patch = polynomial_patch();
  for (double u = -0.1; u <= 1.1; u += 0.1) {
    for (double v = -0.1; v <= 1.1; v += 0.1) {
      const Jet jet = patch->evaluate({u, v}, Order::Second);
      const Jet exact = bicubic_polynomial({u, v});
      EXPECT_LT((jet.point - exact.point).norm(), 1e-13);
      EXPECT_LT((jet.du - exact.du).norm(), 1e-13);
      EXPECT_LT((jet.dv - exact.dv).norm(), 1e-13);
      EXPECT_LT((jet.duu - exact.duu).norm(), 1e-12);
      EXPECT_LT((jet.duv - exact.duv).norm(), 1e-12);
      EXPECT_LT((jet.dvv - exact.dvv).norm(), 1e-12);
    }
  }
}

TEST(BicubicPatchTest, LeavesDerivativesAboveTheOrderUnset) {
  const auto patch = polynomial_patch();
  EXPECT_TRUE(patch->evaluate({0.5, 0.5}, Order::Position).du.array().isNaN().all());
  EXPECT_TRUE(patch->evaluate({0.5, 0.5}, Order::First).duu.array().isNaN().all());
}

TEST(BicubicPatchTest, RefusesAPointThatIsNotFinite) {
  EXPECT_THROW(polynomial_patch()->evaluate({kUnset, 0}, Order::Position), Error);
}

}  // namespace
}  // namespace surfmesh
