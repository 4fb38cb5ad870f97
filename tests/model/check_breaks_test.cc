// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/check_breaks.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/formula/formula_curve.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/model/join_sides.hh"

namespace surfmesh {
namespace {

PatchInput graph(const std::string& z, const Domain& domain = {}, const std::string& name = "a") {
  return {name, std::make_shared<FormulaSurface>(SurfaceFormulas{.z = z}, domain)};
}

/// The shortfalls of a graph.
std::vector<std::string> shortfalls_of(const std::string& z, const Domain& domain = {}) {
  return texts_of(model_from_patches({graph(z, domain)}).notices, Severity::Shortfall);
}

ContourInput circle(double radius, Uv centre = {0.5, 0.5}) {
  const auto along = [&](double middle, const char* wave) {
    return std::to_string(middle) + "+" + std::to_string(radius) + "*" + wave + "(2*pi*t)";
  };
  return {
      "hole",
      nullptr,
      {{"a", std::make_shared<FormulaCurve>(
                 CurveFormulas{along(centre.u, "cos"), along(centre.v, "sin")}, CurveRange{})}}};
}

/// The unit square with a round hole, or only what is inside of the circle.
Model trimmed(const std::string& z, const ContourInput& contour, bool is_hole = true) {
  PatchInput patch = graph(z);
  if (is_hole) patch.loops = {{"a:v0", "a:u1", "-a:v1", "-a:u0"}};
  patch.loops.push_back({is_hole ? "-hole" : "hole"});
  return model_from_patches({patch}, {contour});
}

TEST(CheckBreaks, TellsAJumpWithItsPlace) {
  const Model model = model_from_patches({graph("u"), graph("if(u<0.37,0,0.5)", {}, "b")});
  ASSERT_EQ(model.notices.size(), 1U);
  const Notice& notice = model.notices.front();
  EXPECT_EQ(notice.kind, NoticeKind::SurfaceJump);
  EXPECT_EQ(notice.severity, Severity::Shortfall);
  EXPECT_EQ(notice.patch, 1);
  ASSERT_TRUE(notice.point.has_value());
  EXPECT_NEAR(notice.point->x(), 0.37, 1e-8);
  EXPECT_TRUE(notice.text.starts_with("patch b: its surface jumps by 0.5 at (u,v) = (0.37, "));
  EXPECT_TRUE(
      notice.text.ends_with(", along u = 0.37, as a comparison or step does, and the mesh "
                            "has a cliff there: divide the patch at u = 0.37, each part "
                            "with the formula of its side"))
      << notice.text;
}

TEST(CheckBreaks, TellsTheGreatestHeightAlongALine) {
  const std::vector<std::string> told = shortfalls_of("v*step(0.37,u)");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(
      told[0].starts_with("patch a: its surface jumps by up to 1 at (u,v) = (0.37, 1), "
                          "along u = 0.37"))
      << told[0];
}

TEST(CheckBreaks, TellsThatThereMayBeMoreJumps) {
  const std::vector<std::string> told = shortfalls_of("floor(10*u)");
  ASSERT_GE(told.size(), 3U);
  const std::string more = "; there may be more, which the search left out";
  EXPECT_TRUE(told.back().ends_with(more)) << told.back();
  EXPECT_FALSE(told.front().ends_with(more)) << told.front();
  const std::vector<std::string> all = shortfalls_of("step(0.37,u)+step(0.61,v)");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all.back().ends_with(more)) << all.back();
}

TEST(CheckBreaks, TellsZeroWithoutTheRoundingOfTheSearch) {
  const std::vector<std::string> told = shortfalls_of("sign(u)", {-0.55, 0.45, 0, 1});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("at (u,v) = (0, "), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("along u = 0, "), std::string::npos) << told[0];
}

TEST(CheckBreaks, TellsAJumpOfTheSideAlone) {
  const std::vector<std::string> told = shortfalls_of("mod(u,1)");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].ends_with("side u1 needs the formula of the points beside it")) << told[0];
  EXPECT_TRUE(shortfalls_of("cos(2*pi*mod(u,1))").empty());
  EXPECT_TRUE(shortfalls_of("atan2(sin(u),cos(u))", {-3, 3, 0, 1}).empty());
}

TEST(CheckBreaks, OnlyWarnsOfSmallJumps) {
  const Model model = model_from_patches({graph("1e-5*step(0.37,u)")});
  ASSERT_EQ(model.notices.size(), 1U);
  EXPECT_EQ(model.notices[0].severity, Severity::Warning);
}

/// What a jump is told to be mended by.
TEST(CheckBreaks, TellsNothingOfADividedPatch) {
  for (const auto& [left, right] : {std::pair("0", "1"), std::pair("u", "u-0.37")}) {
    const Model model =
        model_from_patches({graph(left, {0, 0.37, 0, 1}), graph(right, {0.37, 1, 0, 1}, "b")});
    EXPECT_TRUE(texts_of(model.notices, Severity::Shortfall).empty());
  }
}

TEST(CheckBreaks, RefusesInfinity) {
  const auto error = [](const std::string& z) {
    return error_of([&] { model_from_patches({graph(z)}); });
  };
  const std::string line = error("1/(u-0.3)");
  EXPECT_TRUE(line.starts_with("geometry: patch a: its surface runs to infinity at (u,v) = (0.3, "))
      << line;
  EXPECT_TRUE(
      line.ends_with(", along u = 0.3, as a quotient does: let the domain end before it, "
                     "and a second patch begin behind it"))
      << line;
  EXPECT_EQ(error("1/hypot(u-0.41,v-0.53)"),
            "geometry: patch a: its surface runs to infinity at (u,v) = (0.41, 0.53), as a "
            "quotient does: let the domain keep away from it");
  EXPECT_NE(error("if(u>0.37,log(u-0.37),0)").find("(0.37, "), std::string::npos);
}

TEST(CheckBreaks, LeavesWhatLoopsCutOff) {
  const std::string pole = "0.01/hypot(u-0.41,v-0.53)";
  EXPECT_EQ(error_of([&] { trimmed(pole, circle(0.2)); }), "no error");
  EXPECT_NE(error_of([&] {
              trimmed(pole, circle(0.1, {0.2, 0.2}));
            }).find("runs to infinity"),
            std::string::npos);
  EXPECT_TRUE(trimmed("step(0.37,u)", circle(0.1, {0.2, 0.2}), false).notices.empty());
  EXPECT_EQ(trimmed("step(0.37,u)", circle(0.1, {0.4, 0.2}), false).notices.size(), 1U);
  EXPECT_TRUE(trimmed("if(hypot(u-0.4,v-0.6)<0.15,1,0)", circle(0.2, {0.4, 0.6})).notices.empty());
}

TEST(CheckBreaks, RefusesContoursThatJump) {
  const auto error = [](const CurveFormulas& formulas, const CurveRange& range = {}) {
    const ContourInput contour = {
        "c", nullptr, {{"a", std::make_shared<FormulaCurve>(formulas, range)}}, range};
    return error_of([&] { model_from_patches({graph("0")}, {contour}); });
  };
  EXPECT_EQ(error({"0.5+0.2*cos(t)", "if(t<2,0.2,0.7)"}, {0, 6}),
            "geometry: contour c: the curve jumps by 0.5 at t = 2, as a comparison or step does: "
            "divide it there, each part with a formula of its own");
  EXPECT_NE(error({"t", "0.5+0.01/(t-0.3)"}).find("runs to infinity at t = 0.3"),
            std::string::npos);
  EXPECT_EQ(error({"t", "if(t<0.4,t,0.4)"}), "no error");
  // The value at the end is that of the next period.
  const CurveFormulas saw = {"0.2+0.1*mod(t,1)", "0.3"};
  EXPECT_NE(error(saw, {0, 1}).find("let its range stop short of there, at 0.999999999: the end"),
            std::string::npos)
      << error(saw, {0, 1});
  EXPECT_EQ(error(saw, {0, 0.999999999}), "no error");
  EXPECT_EQ(error({"0.5+0.2*cos(2*pi*mod(t,1))", "0.5+0.2*sin(2*pi*mod(t,1))"}), "no error");
}

TEST(CheckBreaks, RefusesContoursInSpaceThatJump) {
  const SpaceCurveFormulas formulas{"t", "0.5*step(0.3,t)", "0"};
  ContourInput contour{"c", std::make_shared<FormulaSpaceCurve>(formulas, CurveRange{})};
  EXPECT_NE(error_of([&] { check_breaks(contour); }).find("jumps by 0.5 at t = 0.3"),
            std::string::npos);
}

}  // namespace
}  // namespace surfmesh
