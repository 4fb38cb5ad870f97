// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/hidden_sizes.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/waves.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

using Function = std::function<double(Uv)>;

std::vector<Uv> hidden_in(const FieldSource& source, const Surface& surface = test::kUnitPlane) {
  PatchSources sources;
  sources.fields.push_back(source);
  return find_hidden(SizeField(surface, resolve(testing::sizing_of(0, 0.0001, 1, 2), 1), sources));
}

std::vector<Uv> hidden_in(const Function& size, const Surface& surface = test::kUnitPlane) {
  return hidden_in(FieldSource{0, [size](Uv uv, const Vec3&) { return size(uv); }}, surface);
}

/// Falls from 0.1 to 0.002 over half the width.
double dent(double distance, double width) {
  return 0.002 + 0.098 * std::min(1.0, 2 * std::abs(distance) / width);
}

TEST(HiddenSizes, AreFoundInBands) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  int missed = 0;
  for (int i = 0; i < 50; ++i) {
    const double angle = std::numbers::pi * share(random);
    const Uv at = {0.2 + 0.6 * share(random), 0.2 + 0.6 * share(random)};
    const Function size = [=](Uv uv) {
      return dent(std::cos(angle) * (uv.u - at.u) + std::sin(angle) * (uv.v - at.v), 0.002);
    };
    const std::vector<Uv> found = hidden_in(size);
    missed += found.empty();
    for (const Uv uv : found) EXPECT_LT(size(uv), 0.07);
  }
  EXPECT_LE(missed, 1);
}

TEST(HiddenSizes, AreFoundInStraightBandsAndRings) {
  for (const double x : {0.25, 0.317, 0.4, 0.6}) {
    EXPECT_GT(hidden_in([x](Uv uv) { return dent(uv.u - x, 0.005); }).size(), 20u) << x;
    EXPECT_GT(hidden_in([x](Uv uv) { return dent(uv.v - x, 0.005); }).size(), 20u) << x;
  }
  EXPECT_GT(
      hidden_in([](Uv uv) { return dent(std::hypot(uv.u - 0.5, uv.v - 0.5) - 0.3, 0.005); }).size(),
      20u);
}

TEST(HiddenSizes, AreFoundInMostSpots) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  int found = 0;
  for (int i = 0; i < 50; ++i) {
    const Uv at = {share(random), share(random)};
    found +=
        !hidden_in([=](Uv uv) { return dent(std::hypot(uv.u - at.u, uv.v - at.v), 0.01); }).empty();
  }
  EXPECT_GE(found, 40);
}

TEST(HiddenSizes, AreFoundByTheirSlopes) {
  const std::vector<Uv> found = hidden_in([](Uv uv) {
    const double distance = std::hypot(uv.u - 0.414213, uv.v - 0.618033) / 0.001;
    return 0.1 - 0.098 * std::exp(-distance * distance / 20);
  });
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].u, 0.414213, 0.003);
  EXPECT_NEAR(found[0].v, 0.618033, 0.003);
}

TEST(HiddenSizes, AreNotThereInSmoothFields) {
  for (const Function& size : std::initializer_list<Function>{
           [](Uv) { return 0.1; }, [](Uv uv) { return 0.01 + 0.1 * uv.u; },
           [](Uv uv) { return 0.05 + 0.04 * std::sin(20 * uv.u) * std::cos(30 * uv.v); },
           [](Uv uv) { return 0.01 + 0.2 * std::hypot(uv.u - 0.4, uv.v - 0.3); }}) {
    EXPECT_TRUE(hidden_in(size).empty());
  }
}

TEST(HiddenSizes, AreLookedForAtABoundedCost) {
  std::atomic<int> count = 0;
  hidden_in([&](Uv uv) {
    ++count;
    return dent(std::hypot(uv.u - 0.3, uv.v - 0.4), 0.3) + 0.01 * std::sin(70 * uv.u);
  });
  EXPECT_LE(count, 16'281);
}

TEST(HiddenSizes, AreLookedForInFieldsWithoutBounds) {
  EXPECT_TRUE(hidden_in(formula_field("0.002+0.098*min(1,abs(u-0.317)/0.005)")).empty());
}

TEST(HiddenSizes, LieInsideTriangles) {
  const test::PlanePatch surface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                                 {0, 1, 0, 1, Domain::Shape::Triangle});
  const std::vector<Uv> found = hidden_in([](Uv uv) { return dent(uv.u - 0.317, 0.005); }, surface);
  EXPECT_GT(found.size(), 10u);
  for (const Uv uv : found) EXPECT_LE(uv.u + uv.v, 1 + 1e-12);
}

TEST(HiddenSizes, AreNotLookedForPastABadSize) {
  const std::string text = error_of([] { hidden_in([](Uv uv) { return uv.u - 0.5; }); });
  EXPECT_NE(text.find("is not positive and finite"), std::string::npos) << text;
}

}  // namespace
}  // namespace surfmesh
