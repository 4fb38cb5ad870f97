// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/jet_number.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "surfmesh/formula/formula.hh"

namespace surfmesh {
namespace {

using Jet2 = JetNumber<2>;

/// A formula and a point where it is smooth.
struct Case {
  std::string text;
  double u;
  double v;
};

void PrintTo(const Case& test_case, std::ostream* out) { *out << test_case.text; }

class JetNumberDerivatives : public ::testing::TestWithParam<Case> {};

/// Central differences: of values for the first derivatives, of first derivatives for the second.
TEST_P(JetNumberDerivatives, AgreeWithFiniteDifferences) {
  const auto& [text, u, v] = GetParam();
  const Formula formula = parse_formula(text, {"u", "v"});
  const double h = 1e-5;
  const auto at = formula.evaluate<2>(u, v);
  const auto east = formula.evaluate<1>(u + h, v), west = formula.evaluate<1>(u - h, v);
  const auto north = formula.evaluate<1>(u, v + h), south = formula.evaluate<1>(u, v - h);
  const auto near = [&](double exact, double plus, double minus) {
    EXPECT_NEAR(exact, (plus - minus) / (2 * h), 1e-8 * (1 + std::abs(exact)));
  };
  near(at.du(), east.value(), west.value());
  near(at.dv(), north.value(), south.value());
  near(at.duu(), east.du(), west.du());
  near(at.duv(), north.du(), south.du());
  near(at.duv(), east.dv(), west.dv());
  near(at.dvv(), north.dv(), south.dv());
}

INSTANTIATE_TEST_SUITE_P(Operations, JetNumberDerivatives,
                         ::testing::Values(Case{"-(u*v)+u-v", 0.7, 1.3},
                                           Case{"(u*u*v)/(1+u*v)", 0.7, 1.3},
                                           Case{"3-u*v+2", 0.7, 1.3}, Case{"2/(u*v)", 0.7, -1.3},
                                           Case{"(u*v)/7*3", 0.7, 1.3},
                                           Case{"(u*v)^2", -0.7, 1.3}));

INSTANTIATE_TEST_SUITE_P(Powers, JetNumberDerivatives,
                         ::testing::Values(Case{"(u*v)^3", -0.7, 1.3}, Case{"(u*v)^7", -0.7, 1.3},
                                           Case{"(u*v)^-1", -0.7, 1.3}, Case{"(u*v)^-4", -0.7, 1.3},
                                           Case{"(u*v)^17", -0.9, 1.1},
                                           Case{"(u*v)^-20", -1.1, 1.1},
                                           Case{"(u*v)^0.5", 0.7, 1.3},
                                           Case{"(u*v)^-1.7", 0.7, 1.3}, Case{"u^v", 0.7, 1.3},
                                           Case{"pow(u*v,u+v)", 0.7, 1.3},
                                           Case{"2^(u*v)", 0.7, 1.3}, Case{"e^(u*v)", -0.7, 1.3}));

INSTANTIATE_TEST_SUITE_P(
    Functions, JetNumberDerivatives,
    ::testing::Values(Case{"sqrt(u*v)", 0.7, 1.3}, Case{"cbrt(u*v)", -0.7, 1.3},
                      Case{"exp(u*v)", 0.7, 1.3}, Case{"log(u*v)", 0.7, 1.3},
                      Case{"sin(u*v)", 0.7, 1.3}, Case{"cos(u*v)", 0.7, 1.3},
                      Case{"tan(u*v)", 0.7, 1.3}, Case{"asin(u*v)", 0.5, 1.3},
                      Case{"acos(u*v)", 0.5, 1.3}, Case{"atan(u*v)", 0.7, 1.3},
                      Case{"sinh(u*v)", 0.7, 1.3}, Case{"cosh(u*v)", 0.7, 1.3},
                      Case{"tanh(u*v)", 0.7, 1.3}, Case{"abs(u*v)", -0.7, 1.3},
                      Case{"min(u*v,u+v)", 0.7, 1.3}, Case{"max(u*v,u+v)", 0.7, 1.3},
                      Case{"max(u*v,1)", 0.7, 1.3}, Case{"hypot(u*v,u-2*v)", 0.7, 1.3},
                      Case{"hypot(u,3)", 0.7, 1.3}, Case{"atan2(u*v,u-v)", 0.7, 1.3},
                      Case{"atan2(u*v,u-v)", -0.7, -1.3}, Case{"atan2(u,-2)", 0.7, 1.3}));

TEST(JetNumberPower, IsRightAtZero) {
  const auto at_zero = [](double c) { return pow(Jet2::parameter(0, 0), c); };
  const auto expect = [](const Jet2& x, double value, double first, double second) {
    EXPECT_EQ(x.value(), value);
    EXPECT_EQ(x.du(), first);
    EXPECT_EQ(x.duu(), second);
    EXPECT_EQ(x.dv(), 0);
    EXPECT_EQ(x.duv(), 0);
  };
  expect(at_zero(0), 1, 0, 0);
  expect(at_zero(1), 0, 1, 0);
  expect(at_zero(2), 0, 0, 2);
  expect(at_zero(3), 0, 0, 0);
  expect(at_zero(20), 0, 0, 0);
  expect(at_zero(2.5), 0, 0, 0);
}

TEST(JetNumberPower, OfNegativeBaseIsThatOfMultiplication) {
  const Jet2 x = Jet2::parameter(-3, 0);
  EXPECT_EQ(pow(x, 3.0).value(), -27);
  EXPECT_EQ(pow(x, 3.0).du(), 27);
  EXPECT_EQ(pow(x, 3.0).duu(), -18);
  EXPECT_EQ(pow(x, 21).value(), std::pow(-3.0, 21));
  EXPECT_TRUE(std::isnan(pow(x, 0.5).value()));
}

TEST(JetNumberPower, ByMultiplicationIsAccurate) {
  for (int n = -16; n <= 16; ++n) {
    for (double x = -3.1; x < 3; x += 0.173) {
      const long double exact = std::pow(static_cast<long double>(x), n);
      const auto error = std::abs(pow(Jet2::parameter(x, 0), n).value() / exact - 1);
      EXPECT_LE(error, 17 * 0x1p-53L) << x << "^" << n;
    }
  }
}

TEST(JetNumberPower, WithVariableExponentIsRightAtZeroBase) {
  const Jet2 zero = Jet2::parameter(0, 0);
  const Jet2 two = Jet2::parameter(2, 1);
  const Jet2 result = pow(zero, two);
  EXPECT_EQ(result.value(), 0);
  EXPECT_EQ(result.du(), 0);
  EXPECT_EQ(result.dv(), 0);
  EXPECT_EQ(result.duu(), 2);
  EXPECT_EQ(result.duv(), 0);
  EXPECT_EQ(result.dvv(), 0);
}

TEST(JetNumberPower, OfConstantZeroIsConstant) {
  const Jet2 result = pow(0.0, Jet2::parameter(2, 0));
  EXPECT_EQ(result.value(), 0);
  EXPECT_EQ(result.du(), 0);
  EXPECT_EQ(result.duu(), 0);
}

TEST(JetNumber, AbsoluteValueHasSlopeZeroAtZero) {
  const Jet2 result = abs(Jet2::parameter(0, 0));
  EXPECT_EQ(result.value(), 0);
  EXPECT_EQ(result.du(), 0);
  EXPECT_EQ(result.duu(), 0);
}

TEST(JetNumber, DerivativesThatDoNotExistAreNotFinite) {
  const Jet2 zero = Jet2::parameter(0, 0);
  EXPECT_EQ(sqrt(zero).value(), 0);
  EXPECT_FALSE(std::isfinite(sqrt(zero).du()));
  EXPECT_FALSE(std::isfinite(cbrt(zero).du()));
  EXPECT_FALSE(std::isfinite(pow(zero, 0.5).du()));
  EXPECT_EQ(pow(zero, 1.5).du(), 0);
  EXPECT_FALSE(std::isfinite(pow(zero, 1.5).duu()));
  EXPECT_FALSE(std::isfinite(hypot(zero, zero).du()));
  EXPECT_FALSE(std::isfinite(asin(Jet2::parameter(1, 0)).du()));
}

TEST(JetNumber, MinAndMaxDoNotHideNotANumber) {
  const Jet2 nan = std::numeric_limits<double>::quiet_NaN();
  for (const Jet2& x :
       {min(nan, Jet2(1)), min(Jet2(1), nan), max(nan, Jet2(1)), max(Jet2(1), nan)}) {
    EXPECT_TRUE(std::isnan(x.value()));
  }
}

TEST(JetNumber, HyperbolicTangentKeepsItsSlopeFarOut) {
  const Jet2 result = tanh(Jet2::parameter(20, 0));
  EXPECT_NEAR(result.du() / (4 * std::exp(-40.0)), 1, 1e-14);
}

TEST(JetNumber, MixesWithNumbersOnEitherSide) {
  const Jet2 x = Jet2::parameter(3, 0);
  EXPECT_EQ((2 * x + 1).value(), 7);
  EXPECT_EQ((1 - x / 2).du(), -0.5);
  EXPECT_EQ((6 / x).value(), 2);
  EXPECT_EQ(Jet2().dvv(), 0);
  EXPECT_TRUE(x > 2 && x == 3 && 4 > x);
  Jet2 y = x;
  y += 1;
  y *= x;
  y -= x;
  y /= x;
  EXPECT_EQ(y.value(), 3);
  EXPECT_EQ(y.du(), 1);
}

TEST(JetNumber, LivesInEigenVectors) {
  using Vector = Eigen::Matrix<Jet2, 3, 1>;
  const Jet2 u = Jet2::parameter(3, 0);
  const Jet2 v = Jet2::parameter(4, 1);
  const Vector a(u, v, 0.0);
  const Vector b = 2.0 * a + Vector(v, u, Jet2(1)) * 0.5;
  EXPECT_EQ(a.norm().value(), 5);
  EXPECT_NEAR(a.norm().du(), 0.6, 1e-15);
  EXPECT_NEAR(a.norm().duu(), 16.0 / 125, 1e-15);
  EXPECT_EQ(a.cross(b)[2].value(), 3 * 9.5 - 4 * 8.0);
  EXPECT_NEAR(a.normalized().squaredNorm().du(), 0, 1e-15);
}

}  // namespace
}  // namespace surfmesh
