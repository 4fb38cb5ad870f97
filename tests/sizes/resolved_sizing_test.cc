// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/resolved_sizing.hh"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>

#include "support/errors.hh"
#include "support/models.hh"

namespace surfmesh {
namespace {

TEST(ResolvedSizing, IsInModelUnits) {
  const ResolvedSizing sizing =
      resolve({.hmin = Length::share(0.01), .hmax = Length::units(5), .sag = Length::share(0.001)},
              /*diagonal=*/10);
  EXPECT_DOUBLE_EQ(sizing.bounds.hmin, 0.1);
  EXPECT_EQ(sizing.bounds.hmax, 5);
  EXPECT_DOUBLE_EQ(sizing.sag, 0.01);
  EXPECT_EQ(sizing.bounds.diagonal, 10);
}

TEST(ResolvedSizing, TurnsTheFactorOffBesideASag) {
  EXPECT_EQ(resolve({}, 1).curvature, 0.25);
  EXPECT_EQ(resolve({.sag = Length::units(0.1)}, 1).curvature, 0);
  EXPECT_EQ(resolve({.curvature = 0.2, .sag = Length::units(0.1)}, 1).curvature, 0.2);
}

TEST(ResolvedSizing, TakesSegmentsOfACircleForAFactor) {
  const double arc = std::numbers::pi / 3;
  EXPECT_DOUBLE_EQ(resolve({.segments_per_circle = 6}, 1).curvature, arc);
  EXPECT_DOUBLE_EQ(resolve({.curvature = 0.1, .segments_per_circle = 6}, 1).curvature, arc);
  EXPECT_DOUBLE_EQ(resolve({.segments_per_circle = 6}, 1).bounds.hmin, 1e-5);
  EXPECT_DOUBLE_EQ(resolve({.segments_per_circle = 6, .hmin = Length::share(0.01)}, 1).bounds.hmin,
                   0.01);
}

TEST(ResolvedSizing, MayReferToThePartsOfAModel) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 3, 4), testing::rectangle(10, 0, 16, 8)});
  const ResolvedSizing resolved =
      resolve({.hmin = Length::share(0.01), .shares_of = SharesOf::Part}, model);
  ASSERT_EQ(resolved.part_bounds.size(), 2U);
  EXPECT_DOUBLE_EQ(resolved.part_bounds[0].hmin, 0.05);
  EXPECT_DOUBLE_EQ(resolved.part_bounds[1].hmin, 0.1);
  EXPECT_DOUBLE_EQ(resolved.bounds.hmin, 0.05);
  EXPECT_TRUE(resolve({}, model).part_bounds.empty());
}

TEST(ResolvedSizing, OfOneLengthEverywhereHasNoOtherSizes) {
  Sizing sizing;
  sizing.size = Length::share(0.02);
  const ResolvedSizing resolved = resolve(sizing, 50);
  EXPECT_EQ(resolved.bounds.hmin, 1);
  EXPECT_EQ(resolved.bounds.hmax, 1);
  EXPECT_FALSE(resolved.follows_curvature());
  EXPECT_EQ(resolved.proximity, 0);
  sizing.size = Length::units(0);
  EXPECT_NE(error_of([&] { resolve(sizing, 50); }).find("size = 0"), std::string::npos);
}

TEST(ResolvedSizing, FollowsCurvatureWithAFactorOrASag) {
  EXPECT_TRUE(resolve({}, 1).follows_curvature());
  EXPECT_TRUE(resolve({.sag = Length::units(0.1)}, 1).follows_curvature());
  EXPECT_FALSE(resolve({.curvature = 0}, 1).follows_curvature());
}

/// A sizing with one member out of range, and how its error begins.
struct Fault {
  Sizing sizing;
  std::string option;
};

TEST(ResolvedSizing, RefusesWhatIsOutOfRangeByName) {
  for (const double bad : {-1.0, kUnset, std::numeric_limits<double>::infinity()}) {
    const Fault faults[] = {
        {{.curvature = bad}, "curvature"},      {{.hmin = Length::units(bad)}, "hmin"},
        {{.hmax = Length::units(bad)}, "hmax"}, {{.grade = bad}, "grade"},
        {{.proximity = bad}, "proximity"},      {{.sag = Length::units(bad)}, "sag"}};
    for (const auto& [sizing, option] : faults) {
      EXPECT_EQ(error_of([&, s = sizing] { resolve(s, 1); }).find("invalid option: " + option), 0U)
          << option << " " << bad;
    }
  }
  for (const double bad : {0.99, -1.0, kUnset}) {
    EXPECT_EQ(error_of([&] { resolve({.stretch = bad}, 1); }).find("invalid option: stretch"), 0U);
  }
}

TEST(ResolvedSizing, RefusesNoLength) {
  EXPECT_NE(error_of([] { resolve({.hmin = Length::units(0)}, 1); }), "no error");
  EXPECT_NE(error_of([] { resolve({.sag = Length::share(0)}, 1); }), "no error");
}

TEST(ResolvedSizing, RefusesAnHminAboveHmaxThatOnlyTheSizeOfTheModelTells) {
  const Sizing sizing{.hmin = Length::share(0.1), .hmax = Length::units(5)};
  EXPECT_EQ(resolve(sizing, 50).bounds.hmin, 5);
  EXPECT_EQ(error_of([&] { resolve(sizing, 60); }),
            "invalid option: hmin = 10% must not be above hmax = 5, set both: they are lengths of "
            "6 and 5");
}

}  // namespace
}  // namespace surfmesh
