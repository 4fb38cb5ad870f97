// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_bounds.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "formula/variables.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_slopes.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

FormulaProgram program_of(const std::string& text) {
  return parse_formulas(std::vector<std::string>{text}, kUv);
}

Interval bounds_of(const FormulaProgram& program, const UvBox& box) {
  Interval result;
  bound(program, std::array{box.u, box.v}, std::span(&result, 1));
  return result;
}

Interval bounds_of(const std::string& text, Interval u, Interval v = {0, 0}) {
  return bounds_of(program_of(text), {u, v});
}

double value_of(const FormulaProgram& program, double u, double v) {
  JetNumber<0> result;
  program.evaluate<0>(std::array{JetNumber<0>(u), JetNumber<0>(v)}, std::span(&result, 1));
  return result.value();
}

void expect_near(const Interval& found, const Interval& expected) {
  const auto is_near = [](double a, double b) {
    return a == b || std::abs(a - b) <= 1e-13 * (1 + std::abs(b));
  };
  EXPECT_TRUE(is_near(found.lower, expected.lower)) << found.lower << " " << expected.lower;
  EXPECT_TRUE(is_near(found.upper, expected.upper)) << found.upper << " " << expected.upper;
}

using Random = std::mt19937;
using Bound = void (*)(const FormulaProgram&, std::span<const Interval>, std::span<Interval>);

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// Intervals of widths from 0 to some units; many end at whole numbers, where functions have their
/// poles and limits.
Interval random_interval(Random& random) {
  double a = uniform(random, -4, 4), width = std::pow(10, uniform(random, -6, 1));
  const auto kind = random() % 6;
  if (kind == 0) a = std::round(a);
  if (kind == 1) a = std::round(a) - width;
  if (kind == 2) width = 0;
  return {a + 0.0, a + width + 0.0};  // without −0
}

/// Both ends, or a point between them.
double random_point(Random& random, const Interval& x) {
  const auto kind = random() % 4;
  if (kind == 0) return x.lower;
  if (kind == 1) return x.upper;
  return std::min(std::max(uniform(random, 0, 1) * x.width() + x.lower, x.lower), x.upper);
}

/// Some random operations, all of which are results.
FormulaProgram random_program(Random& random) {
  FormulaBuilder builder(2);
  std::vector<int> nodes = {0, 1};
  const auto any = [&] { return nodes[random() % nodes.size()]; };
  const auto count = 1 + random() % 8;
  for (std::size_t i = 0; i < count; ++i) {
    const auto last = static_cast<unsigned>(Operation::Select);
    auto operation = static_cast<Operation>(1 + random() % last);
    int a = any(), b = any();
    // The builder makes the forms with a constant.
    if (operation >= Operation::AddConstant && operation <= Operation::PowerBase) {
      operation = random() % 2 == 0 ? Operation::Power : static_cast<Operation>(2 + random() % 4);
      const double whole = static_cast<double>(random() % 9) - 4;
      (random() % 2 == 0 ? a : b) =
          builder.constant(random() % 3 == 0 ? uniform(random, -3, 3) : whole);
    }
    nodes.push_back(builder.apply(operation, a, b, any()));
  }
  return builder.finish(nodes);
}

/// After a result that is not finite, or −0, the sign of a zero may decide.
bool is_plain(double x) { return std::isfinite(x) && !(x == 0 && std::signbit(x)); }

/// Compare bounds with the values at some points of the box, as long as values are plain.
void expect_inside(const FormulaProgram& program, const UvBox& box, Random& random,
                   Bound bound_all = bound) {
  std::vector<Interval> bounds(program.result_count());
  bound_all(program, std::array{box.u, box.v}, bounds);
  std::vector<JetNumber<0>> values(program.result_count());
  for (int i = 0; i < 20; ++i) {
    const double u = random_point(random, box.u), v = random_point(random, box.v);
    program.evaluate<0>(std::array{JetNumber<0>(u), JetNumber<0>(v)}, values);
    for (std::size_t k = 0; k < values.size() && is_plain(values[k].value()); ++k) {
      EXPECT_TRUE(bounds[k].contains(values[k].value()))
          << values[k].value() << " at " << u << ", " << v << " is not in " << bounds[k].lower
          << " to " << bounds[k].upper << ", for u from " << box.u.lower << " to " << box.u.upper;
    }
  }
}

TEST(FormulaBounds, HoldAllValuesOfRandomPrograms) {
  Random random(1);
  for (int i = 0; i < 30'000 && !::testing::Test::HasFailure(); ++i) {
    expect_inside(random_program(random), {random_interval(random), random_interval(random)},
                  random);
  }
}

TEST(FormulaBounds, HoldAllValuesOfEachFunction) {
  Random random(2);
  for (const std::string text : {"sqrt(u)",
                                 "cbrt(u)",
                                 "exp(u)",
                                 "log(u)",
                                 "sin(u)",
                                 "cos(u)",
                                 "tan(u)",
                                 "asin(u)",
                                 "acos(u)",
                                 "atan(u)",
                                 "sinh(u)",
                                 "cosh(u)",
                                 "tanh(u)",
                                 "abs(u)",
                                 "atan2(u,v)",
                                 "min(u,v)",
                                 "max(u,v)",
                                 "hypot(u,v)",
                                 "u^v",
                                 "u^2",
                                 "u^3",
                                 "u^-3",
                                 "u^-2",
                                 "u^17",
                                 "u^-18",
                                 "u^-17",
                                 "u^0.5",
                                 "u^-1.5",
                                 "2^u",
                                 "0.5^u",
                                 "0^u",
                                 "(-2)^u",
                                 "u/v",
                                 "1/u",
                                 "u-v",
                                 "3-u",
                                 "u/-3",
                                 "sin(300000*u)",
                                 "cos(1e17*u)",
                                 "exp(900*u)",
                                 "log(u)-log(v)",
                                 "log10(u)",
                                 "sign(u)",
                                 "floor(u)",
                                 "ceil(u)",
                                 "mod(u,1)",
                                 "mod(u,-0.3)",
                                 "mod(u,v)",
                                 "mod(3,v)",
                                 "mod(1e6*u,v)",
                                 "u<v",
                                 "u<=v",
                                 "u==v",
                                 "u!=v",
                                 "u>0",
                                 "step(1,u)",
                                 "if(u<v,u,v^2)",
                                 "if(u,3,v)",
                                 "if(u>0,sqrt(u),-1)",
                                 "mod(u+1e-9,1)",
                                 "mod(-1e-20*u,1)"}) {
    const FormulaProgram program = program_of(text);
    SCOPED_TRACE(text);
    for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
      expect_inside(program, {random_interval(random), random_interval(random)}, random);
    }
  }
}

TEST(FormulaBounds, AreExactForMonotoneFunctions) {
  expect_near(bounds_of("exp(u)", {1, 2}), {std::exp(1), std::exp(2)});
  expect_near(bounds_of("log(u)", {1, 2}), {0, std::log(2)});
  expect_near(bounds_of("atan(u)", {-1, 1}), {-0.25 * pi, 0.25 * pi});
  expect_near(bounds_of("acos(u)", {-1, 0.5}), {pi / 3, pi});
  expect_near(bounds_of("u^3+2*v", {-2, 1}, {1, 2}), {-6, 5});
  expect_near(bounds_of("u^-1.5", {0.25, 4}), {0.125, 8});
  expect_near(bounds_of("u^v", {0.5, 2}, {-1, 3}), {0.125, 8});
}

TEST(FormulaBounds, AreExactWhereEachVariableOccursOnce) {
  expect_near(bounds_of("0.002+0.098*min(1,abs(u-0.317)/0.02)", {0.3, 0.33}), {0.002, 0.08530});
  expect_near(bounds_of("hypot(u-0.5,v-0.5)", {0, 1}, {0.25, 0.75}), {0, std::hypot(0.5, 0.25)});
  expect_near(bounds_of("u^2", {-1, 2}), {0, 4});
  expect_near(bounds_of("u^4", {-1, 2}), {0, 16});
  expect_near(bounds_of("u^-2", {-1, 2}), {0.25, kInfinity});
  expect_near(bounds_of("cosh(u)", {-1, 2}), {1, std::cosh(2)});
}

TEST(FormulaBounds, FindTheExtremesOfWaves) {
  expect_near(bounds_of("sin(u)", {0, 2}), {0, 1});
  expect_near(bounds_of("sin(u)", {0.1, 1.5}), {std::sin(0.1), std::sin(1.5)});
  expect_near(bounds_of("sin(u)", {4, 5}), {-1, std::sin(4)});
  expect_near(bounds_of("sin(u)", {100, 107}), {-1, 1});
  expect_near(bounds_of("cos(u)", {-1, 2}), {std::cos(2), 1});
  expect_near(bounds_of("cos(u)", {3, 3.2}), {-1, std::cos(3)});
  expect_near(bounds_of("tan(u)", {-1, 1}), {-std::tan(1), std::tan(1)});
}

TEST(FormulaBounds, AreUnboundedAtPoles) {
  expect_near(bounds_of("tan(u)", {1, 2}), {});
  expect_near(bounds_of("1/u", {-1, 1}), {});
  expect_near(bounds_of("u^-3", {-1, 1}), {});
  expect_near(bounds_of("1/u", {0, 2}), {0.5, kInfinity});
  expect_near(bounds_of("u^-3", {-2, 0}), {-kInfinity, -0.125});
  expect_near(bounds_of("u^v", {0, 0}, {-1, 0}), {});
}

/// −0 to the power of −1 is −∞, which only constant exponents knew of.
TEST(FormulaBounds, HoldPowersOfNegativeZero) {
  const FormulaProgram program = program_of("(u*v)^-0^v");
  const double value = value_of(program, -2, 0);
  EXPECT_EQ(value, -kInfinity);
  EXPECT_TRUE(bounds_of(program, {{-2, -2}, {0, 0}}).contains(value));
}

TEST(FormulaBounds, KnowTheCutOfAngles) {
  expect_near(bounds_of("atan2(u,v)", {-1, 1}, {-2, -1}), {-pi, pi});
  expect_near(bounds_of("atan2(u,v)", {-1, 1}, {1, 2}), {-0.25 * pi, 0.25 * pi});
  expect_near(bounds_of("atan2(u,v)", {0, 1}, {-1, 1}), {0, pi});
  expect_near(bounds_of("atan2(u,v)", {-1, -0.5}, {-1, 1}),
              {std::atan2(-0.5, -1), std::atan2(-0.5, 1)});
}

TEST(FormulaBounds, HoldBothSidesOfAJump) {
  EXPECT_EQ(bounds_of("sign(u)", {-1, 2}), (Interval{-1, 1}));
  EXPECT_EQ(bounds_of("sign(u)", {0, 2}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("floor(u)", {0.5, 2.5}), (Interval{0, 2}));
  EXPECT_EQ(bounds_of("floor(u)", {0.5, 1}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("ceil(u)", {1, 1.5}), (Interval{1, 2}));
  EXPECT_EQ(bounds_of("mod(u,1)", {0.5, 1}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("mod(u,-2)", {0.5, 4}), (Interval{-2, 0}));
  EXPECT_EQ(bounds_of("mod(u,v)", {0.5, 4}, {1, 2}), (Interval{0, 2}));
  EXPECT_EQ(bounds_of("mod(u,v)", {0.5, 4}, {-1, 2}), (Interval{-1, 2}));
  EXPECT_EQ(bounds_of("u<v", {0, 1}, {0.5, 2}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("u<=v", {1, 2}, {0, 1}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("u==0.5", {0, 1}), (Interval{0, 1}));
  EXPECT_EQ(bounds_of("if(u<0.5,2,v)", {0, 1}, {3, 4}), (Interval{2, 4}));
}

TEST(FormulaBounds, AreExactBesideAJump) {
  EXPECT_EQ(bounds_of("sign(u)", {-2, -1}), (Interval{-1, -1}));
  EXPECT_EQ(bounds_of("floor(u)", {1, 1.5}), (Interval{1, 1}));
  EXPECT_EQ(bounds_of("ceil(u)", {1.25, 2}), (Interval{2, 2}));
  EXPECT_EQ(bounds_of("mod(u,1)", {1, 1.75}), (Interval{0, 0.75}));
  EXPECT_EQ(bounds_of("mod(u,-1)", {1.25, 2}), (Interval{-0.75, 0}));
  expect_near(bounds_of("mod(u,v)", {5.1, 5.2}, {2, 2.1}), {0.9, 1.2});
  EXPECT_EQ(bounds_of("u<v", {0, 1}, {1.5, 2}), (Interval{1, 1}));
  EXPECT_EQ(bounds_of("u<v", {1, 2}, {0, 1}), (Interval{0, 0}));
  EXPECT_EQ(bounds_of("u<=v", {0, 1}, {1, 2}), (Interval{1, 1}));
  EXPECT_EQ(bounds_of("u==2", {0, 1}), (Interval{0, 0}));
  EXPECT_EQ(bounds_of("if(u<0.5,2,v)", {0.5, 1}, {3, 4}), (Interval{3, 4}));
  EXPECT_EQ(bounds_of("if(u<0.5,2,v)", {0, 0.25}, {3, 4}), (Interval{2, 2}));
}

TEST(FormulaBounds, HoldThePartThatIsDefined) {
  expect_near(bounds_of("asin(u)", {0.5, 3}), {std::asin(0.5), 0.5 * pi});
  expect_near(bounds_of("log(u)", {-1, 1}), {-kInfinity, 0});
  expect_near(bounds_of("sqrt(u)", {-1, 4}), {0, 2});
  expect_near(bounds_of("u^0.5", {-1, 4}), {0, 2});
}

TEST(FormulaBounds, AreUnboundedWhereNothingIsDefined) {
  for (const std::string text : {"asin(u+2)", "log(-u)", "sqrt(-u)", "(-u)^0.5", "0/(u-u)"}) {
    SCOPED_TRACE(text);
    expect_near(bounds_of(text, {0.1, 0.2}), {});
  }
}

TEST(FormulaBounds, KeepConstants) { expect_near(bounds_of("0.25", {0, 1}), {0.25, 0.25}); }

TEST(FormulaBounds, HoldForSeveralFormulas) {
  const std::vector<std::string> texts = {"u+v", "1", "v"};
  std::array<Interval, 3> results;
  bound(parse_formulas(texts, kUv), std::array{Interval{0, 1}, Interval{2, 5}}, results);
  expect_near(results[0], {2, 6});
  expect_near(results[1], {1, 1});
  expect_near(results[2], {2, 5});
}

/// The excess of the bounds over the range, which many samples give, halves with the box.
TEST(FormulaBounds, ConvergeWithTheWidthOfTheBox) {
  const FormulaProgram program = program_of("(sin(3*u)+u*v-0.5*v^2)/(1+u^2)*exp(-u*v)");
  double last = 0;
  for (int level = 0; level < 8; ++level) {
    const double width = std::ldexp(0.125, -level);
    const UvBox box = {{0.4, 0.4 + width}, {0.3, 0.3 + width}};
    double least = kInfinity, greatest = -kInfinity;
    for (int i = 0; i < 10'000; ++i) {
      const double value = value_of(program, 0.4 + width * (i % 100) / 99.0,  //
                                    0.3 + width * (i / 100) / 99.0);
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
    const double excess = bounds_of(program, box).width() - (greatest - least);
    if (level > 0) {
      EXPECT_LT(excess, 0.6 * last);
    }
    last = excess;
  }
}

TEST(FormulaSlopes, HoldAllValuesOfRandomPrograms) {
  Random random(3);
  for (int i = 0; i < 30'000 && !::testing::Test::HasFailure(); ++i) {
    expect_inside(random_program(random), {random_interval(random), random_interval(random)},
                  random, bound_by_slopes);
  }
}

TEST(FormulaSlopes, AreNoWiderThanBounds) {
  Random random(4);
  for (int i = 0; i < 3'000; ++i) {
    const FormulaProgram program = random_program(random);
    const std::array box = {random_interval(random), random_interval(random)};
    std::vector<Interval> simple(program.result_count()), close = simple;
    bound(program, box, simple);
    bound_by_slopes(program, box, close);
    for (std::size_t k = 0; k < simple.size(); ++k) {
      EXPECT_GE(close[k].lower, simple[k].lower);
      EXPECT_LE(close[k].upper, simple[k].upper);
    }
  }
}

/// (u − ½)⁴ + 1, written out: simple bounds are 500 times as wide.
TEST(FormulaSlopes, CancelWhatOccursSeveralTimes) {
  const FormulaProgram program = program_of("u^4-2*u^3+1.5*u^2-0.5*u+1.0625");
  const std::array<Interval, 2> box = {Interval{0.5, 0.51}, Interval{0, 1}};
  Interval result;
  bound_by_slopes(program, box, std::span(&result, 1));
  EXPECT_LT(result.width(), 0.001);
  EXPECT_TRUE(result.contains(1) && result.contains(1 + 1e-8));
  EXPECT_GT(bounds_of(program, {box[0], box[1]}).width(), 0.01);
}

/// Whole periods are subtracted, not forgotten: u − mod(u,1) is a step.
TEST(FormulaSlopes, CancelBetweenJumps) {
  const auto by_slopes = [](const std::string& text, const Interval& u) {
    Interval result;
    bound_by_slopes(program_of(text), std::array{u, Interval{0, 1}}, std::span(&result, 1));
    return result;
  };
  EXPECT_LT(by_slopes("u-mod(u,1)", {3.1, 3.9}).width(), 1e-12);
  EXPECT_LT(by_slopes("if(u<4,u,u^2)-u", {3.1, 3.9}).width(), 1e-12);
  EXPECT_LT(by_slopes("floor(u)*u-3*u", {3.1, 3.9}).width(), 1e-12);
  EXPECT_TRUE(by_slopes("u-mod(u,1)", {3.1, 4.1}).contains(3));
  EXPECT_TRUE(by_slopes("u-mod(u,1)", {3.1, 4.1}).contains(4));
  EXPECT_TRUE(by_slopes("if(u<4,u,u^2)-u", {3.1, 4.1}).contains(4.1 * 3.1));
}

TEST(FormulaProgram, KnowsWhetherItReadsEachOnce) {
  EXPECT_TRUE(program_of("0.002+0.098*min(1,abs(u-0.317)/0.02)").reads_each_once());
  EXPECT_TRUE(program_of("u^2+v").reads_each_once());
  EXPECT_TRUE(program_of("if(u<1,v,2)").reads_each_once());
  EXPECT_FALSE(program_of("if(u<1,2,u)").reads_each_once());
  EXPECT_FALSE(program_of("u^2+u").reads_each_once());
  EXPECT_FALSE(program_of("sin(u+v)*exp(u+v)").reads_each_once());
}

TEST(FormulaProgram, KnowsItsVariables) {
  EXPECT_TRUE(program_of("sin(u)").uses(0));
  EXPECT_FALSE(program_of("sin(u)").uses(1));
  EXPECT_TRUE(program_of("2*u+v").uses(1));
  EXPECT_FALSE(program_of("sin(v)").uses(0));
  EXPECT_TRUE(program_of("v").uses(1));
  EXPECT_FALSE(program_of("3").uses(0));
  EXPECT_TRUE(program_of("if(1/v<1,3,u)").uses(0));
  EXPECT_FALSE(program_of("if(1<2,v,u)").uses(0));
}

}  // namespace
}  // namespace surfmesh
