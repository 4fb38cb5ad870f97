// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/find_breaks.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "surfmesh/formula/formula.hh"

namespace surfmesh {
namespace {

const UvBox kUnitSquare = {{0, 1}, {0, 1}};

std::vector<FormulaBreak> breaks_of(const std::string& text, const UvBox& box = kUnitSquare,
                                    double size = 1) {
  const auto program = parse_formulas(std::vector<std::string>{"u", "v", text}, {"u", "v"});
  return find_breaks(program, {.box = box, .size = size});
}

/// The only break of a formula.
FormulaBreak break_of(const std::string& text, const UvBox& box = kUnitSquare) {
  const std::vector<FormulaBreak> found = breaks_of(text, box);
  EXPECT_EQ(found.size(), 1U) << text;
  return found.empty() ? FormulaBreak{} : found.front();
}

void expect_jump_at_u(const std::string& text, double u, double height,
                      const UvBox& box = kUnitSquare) {
  const FormulaBreak found = break_of(text, box);
  EXPECT_FALSE(found.is_infinite) << text;
  EXPECT_EQ(found.line, BreakLine::ConstantU) << text;
  EXPECT_NEAR(found.at.u, u, 1e-12) << text;
  EXPECT_NEAR(found.height, height, 1e-6) << text;
}

void expect_infinite(const std::string& text, double u, BreakLine line = BreakLine::ConstantU) {
  const FormulaBreak found = break_of(text);
  EXPECT_TRUE(found.is_infinite) << text;
  EXPECT_EQ(found.line, line) << text;
  EXPECT_NEAR(found.at.u, u, 1e-12) << text;
}

TEST(FindBreaks, FindsJumpsAlongLines) {
  expect_jump_at_u("step(0.37,u)", 0.37, 1);
  expect_jump_at_u("if(u<0.37,0,1)", 0.37, 1);
  expect_jump_at_u("if(u<0.37,v,2+u)", 0.37, 2.37 - break_of("if(u<0.37,v,2+u)").at.v);
  expect_jump_at_u("sign(u-0.3)", 0.3, 2);
  expect_jump_at_u("(u-0.3)/abs(u-0.3)", 0.3, 2);
  expect_jump_at_u("ceil(2*u-0.3)", 0.65, 1, {{0.2, 1}, {0, 1}});
  expect_jump_at_u("atan((u-0.4)^-1)", 0.4, 3.14159265);
  expect_jump_at_u("if(max(0,u-0.5),1,0)", 0.5, 1);
  expect_jump_at_u("1e-3*step(2000.25,u)", 2000.25, 1e-3, {{2000, 2001}, {0, 1}});
}

TEST(FindBreaks, FindsEachLine) {
  for (const char* text : {"floor(3*u)", "mod(u,1/3)"}) {
    std::vector<double> places;
    for (const FormulaBreak& found : breaks_of(text)) places.push_back(found.at.u);
    std::ranges::sort(places);
    // At u = 1 only the side itself is on the next sheet.
    ASSERT_EQ(places.size(), 3U) << text;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(places[i], static_cast<double>(i + 1) / 3, 1e-12) << text;
    }
  }
  EXPECT_EQ(breaks_of("floor(40*u)").size(), kMostBreaks);
}

TEST(FindBreaks, FindsJumpsAlongCurves) {
  const FormulaBreak circle = break_of("if(u^2+v^2<0.25,0,0.5)");
  EXPECT_EQ(circle.line, BreakLine::Other);
  EXPECT_NEAR(std::hypot(circle.at.u, circle.at.v), 0.5, 1e-12);
  EXPECT_NEAR(circle.height, 0.5, 1e-6);

  const FormulaBreak cut = break_of("atan2(v-0.5,u-0.51)");
  EXPECT_EQ(cut.line, BreakLine::ConstantV);
  EXPECT_LT(cut.at.u, 0.51);
  EXPECT_NEAR(cut.at.v, 0.5, 1e-12);
}

/// Neither the samples of the box nor those of a mesh show these.
TEST(FindBreaks, FindsNarrowJumps) {
  const std::vector<FormulaBreak> found = breaks_of("if(abs(u-0.371)<1e-6,0.5,0)");
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found.front().at.u, 0.371, 1.001e-6);
}

TEST(FindBreaks, FindsInfinity) {
  expect_infinite("1/(u-0.3)", 0.3);
  expect_infinite("1/(u-0.3)^2", 0.3);
  expect_infinite("(v+1)/(u-0.3)", 0.3);
  expect_infinite("0.1*abs(u-0.3)^-0.5", 0.3);
  expect_infinite("if(u>0.37,log(u-0.37),0)", 0.37);
  expect_infinite("0.1*log10(abs(u-0.37))", 0.37);
  expect_infinite("tan(4*u)", 0.39269908169872414);
  expect_infinite("1/hypot(u-0.41,v-0.53)", 0.41, BreakLine::Other);
}

TEST(FindBreaks, LeavesContinuousFormulas) {
  for (const char* text : {"if(u<0.37,0,u-0.37)",
                           "abs(u-0.37)",
                           "max(u,v)/(1+u*v)",
                           "sin(9*(u-0.3))/(u-0.3)",
                           "if(u==0.3,1,sin(u-0.3)/(u-0.3))",
                           "(1-cos(u-0.3))/(u-0.3)^2",
                           "(exp(u-0.3)-1-(u-0.3))/(u-0.3)^2",
                           "sqrt(u)",
                           "tanh(1e6*(u-0.37))",
                           "if(u<0.37,0,tanh(1e5*(u-0.37)))",
                           "if(u<0.37,0,(u-0.37)^0.2)",
                           "if(u>0.37,(u-0.37)*log(u-0.37),0)",
                           "cos(2*pi*mod(3*u,1))",
                           "abs(mod(3*u,1)-0.5)",
                           "cos(atan2(v-0.5,u-0.51))*hypot(u-0.51,v-0.5)",
                           "atan2(v-0.5,u-0.51)^2*hypot(u-0.51,v-0.5)",
                           "1/(u^2-0.6*u+0.09+1e-3)",
                           "1/(1e-8+(u-0.3)^2)",
                           "floor(u/2)",
                           "mod(u,2)",
                           "atan2(v,u-2)",
                           "if(u<0.2,u,if(u<0.4,0.2,if(u<0.6,u-0.2,0.4)))",
                           "1e-7*step(0.37,u)",
                           "log(1e-9+u)"}) {
    EXPECT_TRUE(breaks_of(text).empty()) << text;
  }
}

/// What is beyond the box, or only on its side, is not there.
TEST(FindBreaks, KeepsToTheBox) {
  EXPECT_TRUE(breaks_of("step(0.37,u)", {{0.37, 1}, {0, 1}}).empty());
  EXPECT_TRUE(breaks_of("step(0.37,u)", {{0, 0.3699}, {0, 1}}).empty());
  // The side u = 0.37 itself has the other value.
  expect_jump_at_u("step(0.37,u)", 0.37, 1, {{0, 0.37}, {0, 1}});
  expect_jump_at_u("mod(u,1)", 1, 1);
  EXPECT_TRUE(breaks_of("mod(u,1)", {{0, 0.999999}, {0, 1}}).empty());
}

TEST(FindBreaks, LeavesOutWhatIsNotInside) {
  const auto program =
      parse_formulas(std::vector<std::string>{"u", "v", "step(0.37,u)"}, {"u", "v"});
  BreakSearch search{.box = kUnitSquare, .is_inside = [](Uv uv) { return uv.u > 0.4; }};
  EXPECT_TRUE(find_breaks(program, search).empty());
  search.is_inside = [](Uv uv) { return uv.v > 0.9; };
  const std::vector<FormulaBreak> found = find_breaks(program, search);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_GT(found.front().at.v, 0.9);
}

TEST(FindBreaks, SearchesFormulasOfOneVariable) {
  const auto program = parse_formulas(std::vector<std::string>{"cos(t)", "if(t<2,0,t)"}, {"t"});
  const std::vector<FormulaBreak> found = find_breaks(program, {.box = {{0, 6}, {0, 0}}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found.front().at.u, 2, 1e-11);
  EXPECT_NEAR(found.front().height, 2, 1e-6);
}

}  // namespace
}  // namespace surfmesh
