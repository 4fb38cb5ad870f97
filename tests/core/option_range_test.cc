// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/option_range.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hh"

namespace surfmesh {
namespace {

enum class Letter { A, B };
constexpr std::array kLetters = {OptionWord{"a", 0}, OptionWord{"b", 1}};
constexpr OptionRange kLetter = {"letter", kLetters};

TEST(OptionRange, TellsItselfInWords) {
  EXPECT_EQ(to_text(kLetter), "a or b");
  EXPECT_EQ(to_text(ranges::kPatches), "auto, faces, blocks or regions");
  EXPECT_EQ(to_text(ranges::kGrade), "off, or a number from 1 to 1000000");
  EXPECT_EQ(to_text(ranges::kPrecision), "a number above 0, up to 1000000");
  EXPECT_EQ(to_text(ranges::kThreads), "all, or a whole number from 1 to 256");
  EXPECT_EQ(to_text(ranges::kFeatures), "on or off");
}

TEST(OptionRange, SaysOffInOneWay) {
  for (const OptionRange& range : {ranges::kGrade, ranges::kCurvature, ranges::kSmoothing,
                                   ranges::kReuse, ranges::kFeatures, ranges::kQuads}) {
    EXPECT_EQ(range.read("off"), 0) << range.name;
    EXPECT_EQ(to_text(range, 0), "off") << range.name;
  }
}

TEST(OptionRange, ReadsNumbersInItsRangeOnly) {
  EXPECT_EQ(ranges::kGrade.read("1.5"), 1.5);
  EXPECT_EQ(ranges::kGrade.read("0"), 0);
  for (const char* bad : {"0.5", "nan", "inf", "1x", "", " 1", "-1", "1e300"}) {
    EXPECT_EQ(ranges::kGrade.read(bad), std::nullopt) << bad;
  }
  EXPECT_EQ(ranges::kNodes.read("0"), std::nullopt);
  EXPECT_EQ(ranges::kNodes.read("4.5"), std::nullopt);
  EXPECT_EQ(ranges::kFeatures.read("0"), std::nullopt);
}

TEST(CheckOption, RefusesWhatIsNoNumber) {
  EXPECT_EQ(error_of([] { check_option(ranges::kGrade, std::nan("")); }),
            "invalid option: grade = nan is outside its range: off, or a number from 1 to 1000000");
  EXPECT_NE(error_of([] { check_option(ranges::kReuse, INFINITY); }), "no error");
}

TEST(CheckOption, RefusesCastsThatAreNoChoice) {
  EXPECT_EQ(error_of([] { check_option(kLetter, Letter::B); }), "no error");
  EXPECT_EQ(error_of([] { check_option(kLetter, static_cast<Letter>(17)); }),
            "invalid option: letter = 17 is outside its range: a or b");
}

}  // namespace
}  // namespace surfmesh
