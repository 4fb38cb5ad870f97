// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/length.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <type_traits>

#include "support/errors.hh"

namespace surfmesh {
namespace {

TEST(ParseLength, ReadsUnitsAndShares) {
  EXPECT_EQ(parse_length("0.25").value, 0.25);
  EXPECT_FALSE(parse_length("0.25").is_relative);
  EXPECT_EQ(parse_length(" 1e-3 ").value, 0.001);
  EXPECT_EQ(parse_length("0.1%").value, 0.001);
  EXPECT_EQ(parse_length("7 %").value, 0.07);
  EXPECT_EQ(parse_length("5E+0%").value, 0.05);
  EXPECT_TRUE(parse_length("250%").is_relative);
}

TEST(ParseLength, RefusesWhatIsNoLength) {
  for (const char* text : {"", "%", "x", "1 2", "inf", "nan%", "0.1%%", "1e999", "1e9999999999%"}) {
    EXPECT_EQ(error_of([&] { parse_length(text); }),
              std::string("invalid input: '") + text +
                  "' is no length: a number, or a share of the diagonal such as 0.1%");
  }
}

TEST(ParseLength, ReadsItsOwnTextToTheLastBit) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    for (const bool is_relative : {false, true}) {
      const Length given = is_relative ? Length::share(value) : Length::units(value);
      const Length length = parse_length(to_text(given));
      ASSERT_EQ(length.value, value);
      ASSERT_EQ(length.is_relative, is_relative);
    }
  }
}

TEST(Length, IsMadeByName) {
  EXPECT_EQ(Length::percent(5), Length::share(0.05));
  EXPECT_EQ(Length::percent(0.7), parse_length("0.7%"));  // 0.7 / 100 is another number
  EXPECT_EQ(Length::units(3).in_units(10), 3);
  EXPECT_EQ(Length::share(0.5).in_units(10), 5);
  // {5, true}, meant as 5 %, was taken for 500 %.
  static_assert(!std::is_constructible_v<Length, double, bool>);
  static_assert(!std::is_convertible_v<double, Length>);
}

TEST(Length, IsNoMoreThanTheDiagonalWhereItIsAShare) {
  EXPECT_TRUE(Length::share(1).is_legal() && Length::units(5).is_legal());
  EXPECT_FALSE(Length::share(5).is_legal());
  EXPECT_FALSE(Length::units(-1).is_legal());
  EXPECT_FALSE(Length::units(std::nan("")).is_legal());
}

TEST(LengthRange, RefusesWithNameValueAndRange) {
  const LengthRange sag = {"sag", true}, hmax = {"hmax", false};
  EXPECT_EQ(error_of([&] { check_option(sag, std::nullopt); }), "no error");
  EXPECT_EQ(error_of([&] { check_option(hmax, Length::share(5)); }),
            "invalid option: hmax = 500% is outside its range: a length above 0 in model units, or "
            "a share of the diagonal up to 100%");
  EXPECT_TRUE(error_of([&] {
                check_option(hmax, std::nullopt);
              }).starts_with("invalid option: hmax = off is outside its range: "));
}

TEST(ParseLength, WritesSharesAsAPersonWould) {
  EXPECT_EQ(to_text(Length::share(0.001)), "0.1%");
  EXPECT_EQ(to_text(Length::share(0.07)), "7%");
  EXPECT_EQ(to_text(Length::units(0.5)), "0.5");
}

}  // namespace
}  // namespace surfmesh
