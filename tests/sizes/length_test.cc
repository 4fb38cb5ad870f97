// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/length.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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
      const Length length = parse_length(to_text(Length{value, is_relative}));
      ASSERT_EQ(length.value, value);
      ASSERT_EQ(length.is_relative, is_relative);
    }
  }
}

TEST(ParseLength, WritesSharesAsAPersonWould) {
  EXPECT_EQ(to_text(Length{0.001, true}), "0.1%");
  EXPECT_EQ(to_text(Length{0.07, true}), "7%");
  EXPECT_EQ(to_text(Length{0.5, false}), "0.5");
}

}  // namespace
}  // namespace surfmesh
