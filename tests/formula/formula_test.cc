// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "formula/variables.hh"
#include "support/errors.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using Constants = std::map<std::string, double>;

const char* const kWave = "1.5*sin(2*u)*cos(v/5)*exp(-(u^2+v^2)/1000)";

/// The message of the error that reading the formula gives.
std::string message(const std::string& text, const Constants& constants = {}) {
  try {
    parse_formula(text, kUv, constants);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidInput);
    return error.what();
  }
  return "no error";
}

void expect_message(const std::string& text, const std::string& part,
                    const Constants& constants = {}) {
  const std::string found = message(text, constants);
  EXPECT_NE(found.find(part), std::string::npos) << found;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

std::string repeat(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(FormulaGrammar, PowerBindsFromTheRightAndBeforeALeadingMinus) {
  EXPECT_EQ(evaluate_constant("-2^2"), -4);
  EXPECT_EQ(evaluate_constant("2^3^2"), 512);
  EXPECT_EQ(evaluate_constant("2^-1"), 0.5);
  EXPECT_EQ(evaluate_constant("2^-1^2"), 0.5);
  EXPECT_EQ(evaluate_constant("(-2)^2"), 4);
  EXPECT_EQ(evaluate_constant("3*-2^2"), -12);
}

TEST(FormulaGrammar, TwoStarsArePower) {
  EXPECT_EQ(evaluate_constant("-2**2"), -4);
  EXPECT_EQ(evaluate_constant("2**3**2"), 512);
  EXPECT_EQ(evaluate_constant("2^3**2*2"), 1024);
  EXPECT_EQ(evaluate_constant("2 ** -1"), 0.5);
  expect_message("u* *v", "column 4: expected a number, a name or '(', found '*'");
  expect_message("u***v", "column 4: expected a number, a name or '(', found '*'");
}

TEST(FormulaGrammar, ComparisonsBindLastAndAreOneOrZero) {
  EXPECT_EQ(evaluate_constant("1+1<3"), 1);
  EXPECT_EQ(evaluate_constant("3<1+1"), 0);
  EXPECT_EQ(evaluate_constant("2<2"), 0);
  EXPECT_EQ(evaluate_constant("2<=2"), 1);
  EXPECT_EQ(evaluate_constant("2>2"), 0);
  EXPECT_EQ(evaluate_constant("2>=2"), 1);
  EXPECT_EQ(evaluate_constant("3 > 2"), 1);
  EXPECT_EQ(evaluate_constant("2==2"), 1);
  EXPECT_EQ(evaluate_constant("2!=2"), 0);
  EXPECT_EQ(evaluate_constant("2!=3"), 1);
  EXPECT_EQ(evaluate_constant("10*(1<2)*(3<=4)"), 10);
  EXPECT_EQ(evaluate_constant("max(1>2,3>2)"), 1);
  EXPECT_EQ(evaluate_constant("-1<-(0)"), 1);
}

TEST(FormulaGrammar, IfChoosesByItsCondition) {
  EXPECT_EQ(evaluate_constant("if(1<2,3,4)"), 3);
  EXPECT_EQ(evaluate_constant("if(1>2,3,4)"), 4);
  EXPECT_EQ(evaluate_constant("if(-0.5,3,4)"), 3);
  EXPECT_EQ(evaluate_constant("if(0,sqrt(-1),4)"), 4);
  const Formula formula = parse_formula("if(u<v,u^2,if(u==v,10,sqrt(v-u)))", kUv);
  EXPECT_EQ(formula.evaluate<0>(2, 3).value(), 4);
  EXPECT_EQ(formula.evaluate<0>(3, 3).value(), 10);
  EXPECT_TRUE(std::isnan(formula.evaluate<0>(4, 3).value()));
}

TEST(FormulaGrammar, OtherOperatorsBindFromTheLeft) {
  EXPECT_EQ(evaluate_constant("7-4-2"), 1);
  EXPECT_EQ(evaluate_constant("16/4/2"), 2);
  EXPECT_EQ(evaluate_constant("2+3*4"), 14);
  EXPECT_EQ(evaluate_constant("(2+3)*4"), 20);
  EXPECT_EQ(evaluate_constant("8/4*2"), 4);
  EXPECT_EQ(evaluate_constant("--2"), 2);
  EXPECT_EQ(evaluate_constant("+2 - -3"), 5);
}

TEST(FormulaGrammar, NumbersAreReadAsInC) {
  EXPECT_EQ(evaluate_constant("1e-3"), 1e-3);
  EXPECT_EQ(evaluate_constant(".5"), 0.5);
  EXPECT_EQ(evaluate_constant("2."), 2);
  EXPECT_EQ(evaluate_constant("1.5E+2"), 150);
  EXPECT_EQ(evaluate_constant(" \t1\n"), 1);
}

TEST(FormulaGrammar, NamesArePiEAndTheConstants) {
  EXPECT_EQ(evaluate_constant("pi"), std::numbers::pi);
  EXPECT_EQ(evaluate_constant("PI"), std::numbers::pi);
  EXPECT_EQ(evaluate_constant("PI", {{"PI", 3}}), 3);  // as in files before it was known
  EXPECT_EQ(evaluate_constant("e"), std::numbers::e);
  EXPECT_EQ(evaluate_constant("2*e"), 2 * std::numbers::e);
  EXPECT_EQ(evaluate_constant("a_1*b", {{"a_1", 3}, {"b", 4}}), 12);
}

TEST(FormulaGrammar, FunctionsAreThoseOfC) {
  const std::vector<std::pair<std::string, double>> expected = {{"sqrt(2)", std::sqrt(2)},
                                                                {"cbrt(-8)", -2},
                                                                {"exp(1.5)", std::exp(1.5)},
                                                                {"log(3)", std::log(3)},
                                                                {"sin(2)", std::sin(2)},
                                                                {"cos(2)", std::cos(2)},
                                                                {"tan(2)", std::tan(2)},
                                                                {"asin(.3)", std::asin(.3)},
                                                                {"acos(.3)", std::acos(.3)},
                                                                {"atan(3)", std::atan(3)},
                                                                {"atan2(1,-2)", std::atan2(1, -2)},
                                                                {"sinh(2)", std::sinh(2)},
                                                                {"cosh(2)", std::cosh(2)},
                                                                {"tanh(2)", std::tanh(2)},
                                                                {"abs(-3)", 3},
                                                                {"min(2,-3)", -3},
                                                                {"max(2,-3)", 2},
                                                                {"pow(2,.5)", std::pow(2, .5)},
                                                                {"hypot(3,4)", 5},
                                                                {"ln(3)", std::log(3)},
                                                                {"log10(1000)", 3},
                                                                {"sign(-3)", -1},
                                                                {"sign(0)", 0},
                                                                {"sign(.1)", 1},
                                                                {"floor(-1.5)", -2},
                                                                {"ceil(-1.5)", -1},
                                                                {"step(2,1.9)", 0},
                                                                {"step(2,2)", 1}};
  for (const auto& [text, value] : expected)
    EXPECT_DOUBLE_EQ(evaluate_constant(text), value) << text;
}

TEST(FormulaGrammar, ModHasTheSignOfThePeriod) {
  EXPECT_EQ(evaluate_constant("mod(5.5,2)"), 1.5);
  EXPECT_EQ(evaluate_constant("mod(-0.5,2)"), 1.5);
  EXPECT_EQ(evaluate_constant("mod(5.5,-2)"), -0.5);
  EXPECT_EQ(evaluate_constant("mod(-5.5,-2)"), -1.5);
  EXPECT_EQ(evaluate_constant("mod(-4,2)"), 0);
  EXPECT_EQ(evaluate_constant("atan(1/mod(-4,2))"),
            std::atan(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(evaluate_constant("atan(1/mod(4,-2))"),
            -std::atan(std::numeric_limits<double>::infinity()));
  EXPECT_THROW(evaluate_constant("mod(1,0)"), Error);
  EXPECT_EQ(evaluate_constant("mod(1e308,1e-300)"), std::fmod(1e308, 1e-300));
}

/// So that a surface that is not finite is an error, whatever the formula asks of it.
TEST(FormulaGrammar, NothingHidesWhatIsNoNumber) {
  for (const char* text : {"sign(sqrt(u))", "floor(sqrt(u))", "ceil(sqrt(u))", "mod(sqrt(u),2)",
                           "mod(2,sqrt(u))", "mod(u,0*u)", "sqrt(u)<1", "1<=sqrt(u)", "sqrt(u)==1",
                           "sqrt(u)!=1", "step(0,sqrt(u))", "if(sqrt(u)<1,2,3)"}) {
    const auto value = parse_formula(text, kUv).evaluate<0>(-1).value();
    EXPECT_TRUE(std::isnan(value)) << text << " " << value;
  }
}

TEST(FormulaGrammar, AnyNumberOfVariablesHasAValue) {
  const Formula formula = parse_formula("x+10*y+100*z", {"x", "y", "z"});
  const std::vector<double> at = {1, 2, 3};
  EXPECT_EQ(formula.evaluate(at), 321);
}

TEST(FormulaGrammar, IsListedInTheReference) {
  std::ifstream stream(std::filesystem::path(SURFMESH_SOURCE_DIR) / "libsurfmesh/REFERENCE.md");
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::ranges::replace(text, '\n', ' ');
  EXPECT_NE(text.find('`' + formula_functions() + '`'), std::string::npos)
      << "libsurfmesh/REFERENCE.md must list: " << formula_functions();
}

TEST(FormulaErrors, TellColumnExpectedAndFound) {
  expect_message("", "column 1: expected a number, a name or '(', found the end");
  expect_message("u+", "column 3: expected a number, a name or '(', found the end");
  expect_message("u + *v", "column 5: expected a number, a name or '(', found '*'");
  expect_message("(u", "column 3: expected an operator or ')', found the end");
  expect_message("sin u", "column 5: expected '(' after the function sin, found 'u'");
  expect_message("sin(u", "column 6: expected an operator, ',' or ')', found the end");
  expect_message("u,v", "column 2: expected an operator or the end, found ','");
}

TEST(FormulaErrors, TrailingTextIsNamed) {
  expect_message("2u", "column 2: expected an operator or the end, found 'u'");
  expect_message("u v", "column 3: expected an operator or the end, found 'v'");
  expect_message("u)", "column 2: expected an operator or the end, found ')'");
  expect_message("1..2", "column 3: expected an operator or the end, found '.'");
  expect_message("1e", "column 2: expected an operator or the end, found 'e'");
  expect_message("0x10", "column 2: expected an operator or the end, found 'x10'");
}

TEST(FormulaErrors, ColumnsCountCharactersNotBytes) {
  expect_message("u\u00d7v", "column 2: expected an operator or the end, found '\u00d7'");
  expect_message("\u03c0", "column 1: expected a number, a name or '(', found '\u03c0'");
}

TEST(FormulaErrors, UnknownNamesAreNamed) {
  expect_message("u+w", "column 3: unknown name 'w'. Names: u v pi e");
  expect_message("2*sine(u)", "column 3: unknown function 'sine', did you mean sin? Functions: " +
                                  formula_functions());
  expect_message("SQRT(u)", "unknown function 'SQRT', did you mean sqrt? Functions: ");
  expect_message("fmod(u,2)", "unknown function 'fmod', did you mean mod?");
  expect_message("zzzz(u)", "unknown function 'zzzz'. Functions: ");
  expect_message("E*u", "unknown name 'E', did you mean e? Names: u v pi e");
  expect_message("radios", "unknown name 'radios', did you mean radius? Names: u v radius pi e",
                 {{"radius", 2}});
  expect_message("2*sgn", "unknown name 'sgn', did you mean sign?");
  EXPECT_THROW(evaluate_constant("u"), Error);
}

TEST(FormulaErrors, WrongNumberOfArgumentsIsNamed) {
  expect_message("sin(u,v)", "column 8: the function sin takes 1 argument, not 2");
  expect_message("atan2(u)", "the function atan2 takes 2 arguments, not 1");
  expect_message("max(u,v,1)", "the function max takes 2 arguments, not 3");
  expect_message("exp()", "the function exp takes 1 argument, not 0");
}

TEST(FormulaErrors, LongNamesAndListsAreCut) {
  Constants constants;
  for (int i = 0; i < 1000; ++i) constants[fmt::format("constant_{}", i)] = i;
  EXPECT_LT(message("w+" + repeat("u+", 50000) + "u", constants).size(), 1000u);
  EXPECT_LT(message(repeat("w", 100000), constants).size(), 1000u);
  EXPECT_LT(message(repeat("w", 100000) + "(u)").size(), 1000u);
  EXPECT_LT(message("u " + repeat("w", 100000)).size(), 1000u);
}

TEST(FormulaErrors, ComparisonsDoNotFollowEachOther) {
  expect_message("if(0<u<1,2,3)", "column 7: comparisons do not follow each other: multiply them");
  expect_message("u==v==1", "column 5: comparisons do not follow each other");
  EXPECT_EQ(parse_formula("if((0<u)*(u<1),2,3)", kUv).evaluate<0>(0.5).value(), 2);
}

TEST(FormulaErrors, SignsOfOtherLanguagesAreAdvised) {
  expect_message("if(u=1,2,3)", "column 5: found '='; 'equal' is ==");
  expect_message("if(u>0&&v>0,2,3)", "column 7: found '&&'; for 'and' multiply the comparisons");
  expect_message("if(u||v,2,3)", "column 5: found '||'; for 'or' take the greater comparison");
  expect_message("!u", "column 1: expected a number, a name or '(', found '!'");
  expect_message("u!v", "column 2: expected an operator or the end, found '!'");
  expect_message("u<", "column 3: expected a number, a name or '(', found the end");
}

TEST(FormulaErrors, IfNeedsAllItsParts) {
  expect_message("if(u<1,2)", "the function if takes 3 arguments, not 2: if(condition,a,b)");
  expect_message("if(u<1,2,3,4)", "the function if takes 3 arguments, not 4");
  expect_message("if u<1", "column 4: expected '(' after the function if, found 'u'");
}

TEST(FormulaErrors, NumbersOutOfRangeAreNamed) {
  expect_message("u+1e999", "column 3: the number 1e999 is out of range");
}

TEST(FormulaErrors, ConstantsMustNotRedefineNames) {
  for (const char* name : {"pi", "e", "u", "v", "t", "sin"}) {
    expect_message("u", "would redefine", {{name, 1}});
  }
  EXPECT_THROW(parse_formula("x", {"x"}, {{"x", 1}}), Error);
}

TEST(FormulaErrors, ConstantsMustBeFiniteAndHaveNames) {
  expect_message("u", "the constant '2a' is not a name", {{"2a", 1}});
  expect_message("u", "is not a name", {{"", 1}});
  expect_message("u", "the constant 'a' is not finite",
                 {{"a", std::numeric_limits<double>::infinity()}});
}

TEST(FormulaErrors, AConstantExpressionMustBeFinite) {
  EXPECT_THROW(evaluate_constant("1/0"), Error);
  EXPECT_THROW(evaluate_constant("sqrt(-1)"), Error);
  EXPECT_THROW(evaluate_constant("10^1e300"), Error);
  EXPECT_THROW(evaluate_constant("10**10**10"), Error);
}

TEST(FormulaErrors, DeepNestingIsRefusedAndLongTextIsNot) {
  for (const char* part : {"(", "-", "sin(", "2^", "+", "if(u<1,2,", "2**", "1<("}) {
    expect_message(repeat(part, 100000), "nested more than 200 deep");
  }
  EXPECT_EQ(evaluate_constant("1" + repeat("+1", 100000)), 100001);
  EXPECT_EQ(parse_formula("u" + repeat("*1", 100000), kUv).evaluate<0>(3).value(), 3);
  EXPECT_EQ(evaluate_constant(repeat("(", 199) + "1" + repeat(")", 199)), 1);
}

TEST(FormulaErrors, TooManyOperationsAreRefused) {
  expect_message("u" + repeat("*(1+u)+u", 2000), "operations, of at most");
}

TEST(FormulaProgram, FoldsConstantsAndSharesOperations) {
  EXPECT_EQ(parse_formulas(std::vector<std::string>{"2*3+sin(1)"}, kUv).instructions().size(), 1u);
  const std::vector<std::string> shared = {"sin(u*v)+v*u", "sin(v*u)"};
  EXPECT_EQ(parse_formulas(shared, kUv).instructions().size(), 3u);
  EXPECT_TRUE(parse_formula("2*pi", kUv).is_constant());
  EXPECT_FALSE(parse_formula("u", kUv).is_constant());
}

TEST(FormulaProgram, FoldingKeepsEveryBit) {
  const Formula folded = parse_formula("sin(2)*u/7+3^0.3-(1-v)*cbrt(5)", kUv);
  const Formula plain =
      parse_formula("sin(a)*u/b+c^d-(f-v)*cbrt(g)", {"u", "v", "a", "b", "c", "d", "f", "g"});
  for (double u = -2; u < 2; u += 0.37) {
    const std::vector<double> at = {u, 0.3 + u, 2, 7, 3, 0.3, 1, 5};
    EXPECT_EQ(bits(folded.evaluate<0>(u, 0.3 + u).value()), bits(plain.evaluate(at)));
  }
}

TEST(FormulaReader, ReadsNamedFormulasOnce) {
  const std::vector<NamedFormula> where = {{"r", "1+a*cos(3*u)"}, {"rr", "r*r"}, {"unused", "v^7"}};
  const std::vector<std::string> texts = {"rr*cos(u)", "rr*sin(u)"};
  const FormulaProgram named = parse_formulas(texts, kUv, {{"a", 0.2}}, where);
  const std::vector<std::string> written = {"(1+0.2*cos(3*u))^2*cos(u)",
                                            "(1+0.2*cos(3*u))^2*sin(u)"};
  const FormulaProgram plain = parse_formulas(written, kUv);
  EXPECT_EQ(named.instructions().size(), plain.instructions().size());
  const std::array at = {JetNumber<2>::parameter(0.7, 0), JetNumber<2>::parameter(0.3, 1)};
  std::array<JetNumber<2>, 2> found, expected;
  named.evaluate<2>(at, found);
  plain.evaluate<2>(at, expected);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(bits(found[i].value()), bits(expected[i].value()));
    EXPECT_EQ(bits(found[i].du()), bits(expected[i].du()));
    EXPECT_EQ(bits(found[i].duu()), bits(expected[i].duu()));
  }
}

TEST(FormulaReader, DoesNotGrowWithTheUsesOfANamedFormula) {
  std::vector<NamedFormula> where = {{"a0", "u"}};
  for (int i = 1; i < 500; ++i) {
    const std::string last = fmt::format("a{}", i - 1);
    where.push_back({fmt::format("a{}", i), fmt::format("({0}+{0})/2", last)});
  }
  const std::vector<std::string> texts = {"a499"};
  EXPECT_LT(parse_formulas(texts, kUv, {}, where).instructions().size(), 1000u);
}

TEST(FormulaReader, TellsWhichNamedFormulaIsAtFault) {
  const auto fault = [](const std::vector<NamedFormula>& where) {
    return error_of([&] { parse_formulas({}, kUv, {{"a", 1}}, where); });
  };
  EXPECT_NE(fault({{"r", "1+"}}).find("r: formula \"1+\", column 3: expected"), std::string::npos);
  EXPECT_NE(fault({{"r", "s"}, {"s", "u"}}).find("r: formula \"s\", column 1: unknown name 's'"),
            std::string::npos);
  EXPECT_NE(fault({{"r", "r"}}).find("unknown name 'r'"), std::string::npos);
  EXPECT_NE(fault({{"u", "v"}}).find("the name 'u' would redefine"), std::string::npos);
  EXPECT_NE(fault({{"if", "v"}}).find("the name 'if' would redefine"), std::string::npos);
  EXPECT_NE(fault({{"a", "v"}}).find("the name 'a' is the name of something else"),
            std::string::npos);
  EXPECT_NE(fault({{"r", "v"}, {"r", "u"}}).find("something else"), std::string::npos);
  EXPECT_NE(fault({{"2r", "v"}}).find("the name '2r' is not a name"), std::string::npos);
}

class FormulaOrders : public ::testing::TestWithParam<std::string> {};

TEST_P(FormulaOrders, AgreeBitByBitInTheirCommonMembers) {
  const Formula formula = parse_formula(GetParam(), kUv);
  for (int i = 0; i < 2000; ++i) {
    const double u = 1e-3 + 3 * std::fmod(0.6180339887498949 * i, 1);
    const double v = 1e-3 + 3 * std::fmod(0.7548776662466927 * i, 1);
    const auto zero = formula.evaluate<0>(u, v);
    const auto one = formula.evaluate<1>(u, v);
    const auto two = formula.evaluate<2>(u, v);
    ASSERT_EQ(bits(zero.value()), bits(two.value())) << u << " " << v;
    ASSERT_EQ(bits(one.value()), bits(two.value()));
    ASSERT_EQ(bits(one.du()), bits(two.du()));
    ASSERT_EQ(bits(one.dv()), bits(two.dv()));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, FormulaOrders,
    ::testing::Values(kWave, "u^v/cosh(u-v)", "tanh(u)*tan(v/4)+asin(u/4)*acos(v/4)-u^-3*v^7",
                      "atan2(u,v)+hypot(u,v)*cbrt(u)+sqrt(v)+log(u)+2^v+u^2.5+u^20",
                      "max(u,v)-min(u,2)*abs(v-1)+sinh(u)*atan(v)",
                      "mod(u*v,1+0.2*v)*log10(u)+sign(u-1)*floor(2*v)*u-ceil(u)*step(1,v)*v^2",
                      "if(u<v,u^2*sin(v),if((v>1)*(u!=2),exp(u),v^3))-(u>=v)*u"));

/// A formula, and one without steps that it is in a part of the plane.
struct SameIn {
  std::string text;
  std::string plain;
};

void PrintTo(const SameIn& same, std::ostream* out) { *out << same.text; }

class FormulaSteps : public ::testing::TestWithParam<SameIn> {};

/// u from 0.1 to 0.9, v from 2.1 to 2.9.
TEST_P(FormulaSteps, HaveTheDerivativesOfTheFormulaBetweenThem) {
  const Formula formula = parse_formula(GetParam().text, kUv);
  const Formula plain = parse_formula(GetParam().plain, kUv);
  for (int i = 0; i < 100; ++i) {
    const double u = 0.1 + 0.8 * std::fmod(0.6180339887498949 * i, 1);
    const double v = 2.1 + 0.8 * std::fmod(0.7548776662466927 * i, 1);
    const auto found = formula.evaluate<2>(u, v), expected = plain.evaluate<2>(u, v);
    EXPECT_NEAR(found.value(), expected.value(), 1e-13);
    EXPECT_NEAR(found.du(), expected.du(), 1e-13);
    EXPECT_NEAR(found.dv(), expected.dv(), 1e-13);
    EXPECT_NEAR(found.duu(), expected.duu(), 1e-12);
    EXPECT_NEAR(found.duv(), expected.duv(), 1e-12);
    EXPECT_NEAR(found.dvv(), expected.dvv(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, FormulaSteps,
    ::testing::Values(
        SameIn{"sign(u-1)*u^2*v", "-u^2*v"}, SameIn{"floor(v)*u^2+ceil(u)*v", "2*u^2+v"},
        SameIn{"mod(v^2*u,-100)", "v^2*u-100"}, SameIn{"mod(8.9,v^2)", "mod(8.9,v*v)"},
        SameIn{"mod(10+u,v*v+2)", "10+u-(v*v+2)*floor((10+u)/(v*v+2))"},
        SameIn{"step(1,v)*u*v+step(v,1)", "u*v"}, SameIn{"if(u<v,u^2*v,1/(u-u))", "u^2*v"},
        SameIn{"(u<1)*u^3+(v==1)", "u^3"}, SameIn{"log10(u*v)", "log(u*v)/log(10)"}),
    [](const auto& test) { return fmt::format("Case{}", test.index); });

TEST(Formula, DerivativesOfTheWaveAreThoseOfTheClosedForm) {
  const Formula formula = parse_formula(kWave, kUv);
  for (double u = -6; u <= 6; u += 0.71) {
    for (double v = -6; v <= 6; v += 0.53) {
      const double k = 1.5 * std::exp(-(u * u + v * v) / 1000);
      const double s = std::sin(2 * u), c = std::cos(2 * u);
      const double p = std::cos(v / 5), q = std::sin(v / 5);
      const double x1 = 2 * c - s * u / 500, y1 = -q / 5 - p * v / 500;
      const double x2 = -4 * s - 4 * c * u / 500 - s / 500 + s * (u / 500) * (u / 500);
      const double y2 = -p / 25 + 2 * q * v / 2500 - p / 500 + p * (v / 500) * (v / 500);
      const auto z = formula.evaluate<2>(u, v);
      EXPECT_NEAR(z.value(), k * s * p, 1e-15);
      EXPECT_NEAR(z.du(), k * x1 * p, 1e-14);
      EXPECT_NEAR(z.dv(), k * s * y1, 1e-14);
      EXPECT_NEAR(z.duu(), k * x2 * p, 1e-14);
      EXPECT_NEAR(z.duv(), k * x1 * y1, 1e-14);
      EXPECT_NEAR(z.dvv(), k * s * y2, 1e-14);
    }
  }
}

TEST(Formula, OneVariableIsDerivedAsTheFirst) {
  const auto result = parse_formula("t^3", {"t"}).evaluate<2>(2);
  EXPECT_EQ(result.value(), 8);
  EXPECT_EQ(result.du(), 12);
  EXPECT_EQ(result.duu(), 12);
  EXPECT_EQ(result.dv(), 0);
  EXPECT_EQ(result.duv(), 0);
}

TEST(Formula, ConstantsHaveZeroDerivatives) {
  const auto result = parse_formula("a+1", kUv, {{"a", 2}}).evaluate<2>(5, 6);
  EXPECT_EQ(result.value(), 3);
  EXPECT_EQ(result.du(), 0);
  EXPECT_EQ(result.dvv(), 0);
}

TEST(Formula, FourThreadsGiveTheSerialBits) {
  const Formula formula = parse_formula(kWave, kUv);
  const auto evaluate_all = [&] {
    std::vector<std::uint64_t> result;
    for (int i = 0; i < 20000; ++i) {
      const auto z = formula.evaluate<2>(1e-3 * i, 2 - 1e-3 * i);
      for (double x : {z.value(), z.du(), z.dv(), z.duu(), z.duv(), z.dvv()}) {
        result.push_back(bits(x));
      }
    }
    return result;
  };
  const auto serial = evaluate_all();
  std::vector<std::vector<std::uint64_t>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { result = evaluate_all(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, serial);
}

}  // namespace
}  // namespace surfmesh
