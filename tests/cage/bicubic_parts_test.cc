// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/bicubic_parts.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace surfmesh {
namespace {

using detail::BicubicParts;

/// (u³ v², u v³, u² − v) with all derivatives, and `kink(u)` three times added to z.
template <class Kink>
Jet polynomial_with(Uv p, const Kink& kink) {
  const double u = p.u, v = p.v;
  const auto [value, slope, bend] = kink(u);
  Jet jet;
  jet.point = {u * u * u * v * v, u * v * v * v, u * u - v + value};
  jet.du = {3 * u * u * v * v, v * v * v, 2 * u + slope};
  jet.dv = {2 * u * u * u * v, 3 * u * v * v, -1};
  jet.duu = {6 * u * v * v, 0, 2 + bend};
  jet.duv = {6 * u * u * v, 3 * v * v, 0};
  jet.dvv = {2 * u * u * u, 6 * u * v, 0};
  return jet;
}

Jet polynomial(Uv p) {
  return polynomial_with(p, [](double) { return std::array{0.0, 0.0, 0.0}; });
}

/// |u − 1/4|³: its third derivative jumps.
Jet kinked(Uv p) {
  return polynomial_with(p, [](double u) {
    const double x = u - 0.25, y = std::abs(x);
    return std::array{y * y * y, 3 * x * y, 6 * y};
  });
}

/// √u: no polynomial anywhere.
Jet rooted(Uv p) {
  return polynomial_with(p, [](double u) {
    return std::array{std::sqrt(u), 0.5 / std::sqrt(u), -0.25 / (u * std::sqrt(u))};
  });
}

/// The polynomial, and √u in the last sixteenth of v.
Jet rooted_at_the_top(Uv p) { return p.v > 15.0 / 16 ? rooted(p) : polynomial(p); }

/// Derivatives of a polynomial in a square of the side 1/n lose n² roundings of its points.
void expect_near(const Jet& found, const Jet& exact, double n) {
  const double rounding = 16 * std::numeric_limits<double>::epsilon();
  EXPECT_LT((found.point - exact.point).norm(), rounding);
  EXPECT_LT((found.du - exact.du).norm(), 3 * n * rounding);
  EXPECT_LT((found.dv - exact.dv).norm(), 3 * n * rounding);
  EXPECT_LT((found.duu - exact.duu).norm(), 6 * n * n * rounding);
  EXPECT_LT((found.duv - exact.duv).norm(), 9 * n * n * rounding);
  EXPECT_LT((found.dvv - exact.dvv).norm(), 6 * n * n * rounding);
}

BicubicParts parts_of(Jet (*surface)(Uv)) {
  return BicubicParts([surface](Uv uv, Order) { return surface(uv); });
}

TEST(BicubicParts, OfAPolynomialAreThePolynomial) {
  const BicubicParts parts = parts_of(polynomial);
  for (double u = 0; u <= 1; u += 0.0625) {
    for (double v = 0; v <= 1; v += 0.0625) {
      ASSERT_NE(parts.find({u, v}), nullptr);
      EXPECT_EQ(parts.find({u, v}), parts.find({0.5, 0.5}));
      expect_near(parts.find({u, v})->evaluate({u, v}, Order::Second), polynomial({u, v}), 1);
    }
  }
}

TEST(BicubicParts, OfPiecewisePolynomialsEndWhereTheseDo) {
  const BicubicParts parts = parts_of(kinked);
  for (double u = 0.01; u < 1; u += 0.07) {
    for (double v = 0.01; v < 1; v += 0.07) {
      ASSERT_NE(parts.find({u, v}), nullptr) << u << ' ' << v;
      expect_near(parts.find({u, v})->evaluate({u, v}, Order::Second), kinked({u, v}), 4);
    }
  }
  EXPECT_NE(parts.find({0.2, 0.1}), parts.find({0.3, 0.1}));
  EXPECT_EQ(parts.find({0.6, 0.1}), parts.find({0.9, 0.4}));
}

TEST(BicubicParts, AreNotFoundWhereThereIsNoPolynomial) {
  const BicubicParts parts = parts_of(rooted);
  for (double u = 0; u <= 1; u += 0.03) EXPECT_EQ(parts.find({u, 0.4}), nullptr) << u;
}

TEST(BicubicParts, LeaveOutTheSmallestSquaresThatAreNone) {
  const BicubicParts parts = parts_of(rooted_at_the_top);
  for (double u = 0; u <= 1; u += 0.03) {
    EXPECT_EQ(parts.find({u, 0.9}), nullptr) << u;
    EXPECT_NE(parts.find({u, 0.86}), nullptr) << u;
  }
}

TEST(BicubicParts, LeaveDerivativesAboveTheOrderUnset) {
  const BicubicParts parts = parts_of(kinked);
  EXPECT_TRUE(parts.find({0.1, 0.1})->evaluate({0.1, 0.1}, Order::First).duu.array().isNaN().all());
  EXPECT_TRUE(
      parts.find({0.1, 0.1})->evaluate({0.1, 0.1}, Order::Position).du.array().isNaN().all());
}

}  // namespace
}  // namespace surfmesh
