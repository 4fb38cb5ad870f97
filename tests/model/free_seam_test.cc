// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/free_seam.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/models.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/model/join_sides.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

/// A cylinder over z in [-2,2], with its seam at an angle.
std::shared_ptr<const Surface> pipe(double seam) {
  return make_callable_surface(Domain{seam, seam + 2 * pi, -2, 2}, [](auto u, auto v) {
    return std::array{cos(u), sin(u), v};
  });
}

/// The curve in which a bore of radius 0.4 along x leaves the pipe, towards x or against it.
ContourInput bore(const std::string& name, double towards) {
  return {name, std::make_shared<CallableSpaceCurve>([=](double t) -> Vec3 {
            const double y = 0.4 * std::cos(2 * pi * t);
            return {towards * std::sqrt(1 - y * y), y, 0.4 * std::sin(2 * pi * t)};
          })};
}

const std::vector<std::string> kWallSides = {"wall:v0", "wall:u1", "-wall:v1", "-wall:u0"};

Model bored(double seam, const std::vector<ContourInput>& contours) {
  std::vector<std::vector<std::string>> loops = {kWallSides};
  for (const ContourInput& contour : contours) loops.push_back({"-" + contour.name});
  return model_from_patches({{"wall", pipe(seam), loops}}, contours);
}

std::string fault(double seam, const std::vector<ContourInput>& contours) {
  return error_of([&] { bored(seam, contours); });
}

struct Bounds {
  double from = 0;
  double to = 0;
};

/// The domain that an error advises.
Bounds advised(const std::string& error) {
  const std::string words = "the surface is closed, and with the domain \"u\": [";
  const std::size_t at = error.find(words);
  EXPECT_NE(at, std::string::npos) << error;
  if (at == std::string::npos) return {};
  Bounds bounds;
  EXPECT_EQ(std::sscanf(error.c_str() + at + words.size(), "%lf, %lf]", &bounds.from, &bounds.to),
            2);
  return bounds;
}

// The advice was to divide contours where they cross the seam, which takes four contours for a
// bore.
TEST(FreeSeam, TellsADomainWhoseSeamABoreDoesNotCross) {
  for (const double seam : {0.0, -0.3, 0.2}) {
    const Bounds bounds = advised(fault(seam, {bore("bore", 1)}));
    EXPECT_EQ(bounds.to, bounds.from + 2 * pi);
    EXPECT_EQ(error_of([&] { check(bored(bounds.from, {bore("bore", 1)})); }), "no error");
  }
}

TEST(FreeSeam, KeepsClearOfAllContours) {
  const std::vector<ContourInput> through = {bore("in", 1), bore("out", -1)};
  const Bounds bounds = advised(fault(-pi, through));
  EXPECT_EQ(error_of([&] { check(bored(bounds.from, through)); }), "no error") << bounds.from;
}

TEST(FreeSeam, KeepsCurvesInTheParametersInside) {
  for (const double middle : {-0.2, 0.0, 6.2}) {
    const auto circle = std::make_shared<CallableCurve>([=](double t) {
      return Uv{middle + 0.3 * std::cos(2 * pi * t), 0.3 * std::sin(2 * pi * t)};
    });
    const std::vector<ContourInput> contours = {{"hole", nullptr, {{"wall", circle}}}};
    const Bounds bounds = advised(fault(0, contours));
    EXPECT_EQ(error_of([&] { check(bored(bounds.from, contours)); }), "no error") << bounds.from;
  }
}

TEST(FreeSeam, IsThatWhichIsCrossed) {
  // Around a torus, over the seam of v.
  const auto torus = make_callable_surface(Domain{0, 2 * pi, 0, 2 * pi}, [](auto u, auto v) {
    return std::array{(3.0 + cos(v)) * cos(u), (3.0 + cos(v)) * sin(u), sin(v)};
  });
  const UvPath over_v = {{1, 6}, {1, 6.2}, {1, 0.1}, {1, 0.2}};
  const auto advice = free_seam_advice(*torus, {over_v}, false);
  ASSERT_TRUE(advice);
  EXPECT_NE(advice->find("the domain \"v\": ["), std::string::npos) << *advice;
}

TEST(FreeSeam, IsWrittenWithAllDigits) {
  const auto pipe = make_callable_surface(Domain{1e6, 1e6 + 1, 0, 1}, [](auto u, auto v) {
    return std::array{cos(2 * pi * u), sin(2 * pi * u), v};
  });
  const auto advice = free_seam_advice(*pipe, {{{1e6 + 0.9, 0.5}, {1e6 + 0.1, 0.5}}}, false);
  ASSERT_TRUE(advice);
  EXPECT_NE(advice->find("[999999.5, 1000000.5]"), std::string::npos) << *advice;
}

TEST(FreeSeam, HasNoAdviceWhereASurfaceIsNotClosedOrHasNoRoom) {
  const UvPath over = {{6.2, 0.2}, {0.1, 0.2}};
  EXPECT_FALSE(free_seam_advice(*testing::rectangle(0, 0, 2 * pi, 1), {over}, false));
  UvPath around;
  for (int i = 0; i <= 64; ++i) around.push_back({2 * pi * i / 64, 0});
  EXPECT_FALSE(free_seam_advice(*pipe(0), {around, over}, false));
  EXPECT_FALSE(free_seam_advice(*pipe(0), {{{0.2, 0.2}, {0.4, 0.2}}}, false));
  EXPECT_TRUE(free_seam_advice(*pipe(0), {over}, false));
}

}  // namespace
}  // namespace surfmesh
