// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/short_real.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace surfmesh {
namespace {

std::string plain(double value, std::size_t width) {
  return std::string(ShortReal(value, width, RealStyle::Plain).text());
}

std::string nastran(double value) {
  return std::string(ShortReal(value, 16, RealStyle::Nastran).text());
}

TEST(ShortReal, HasAllDigitsThatFit) {
  EXPECT_EQ(plain(0.5, 20), ".5");
  EXPECT_EQ(plain(-12, 20), "-12");
  EXPECT_EQ(plain(1e-7, 20), "1e-7");
  EXPECT_EQ(plain(1e21, 20), "1e21");
  EXPECT_EQ(plain(-0.012345678901234567, 20), "-.012345678901234567");
}

TEST(ShortReal, IsRoundedToTheWidth) {
  EXPECT_EQ(plain(-1.2345678901234567e-11, 20), "-1.2345678901235e-11");
  EXPECT_EQ(plain(2.0 / 3, 10), ".666666667");
  EXPECT_EQ(plain(9.99999999999, 10), "10.0000000");
  EXPECT_EQ(plain(123456789012345678.0, 12), "1.2345679e17");
}

TEST(ShortReal, HasAPointAndNoEInNastran) {
  EXPECT_EQ(nastran(0), "0.");
  EXPECT_EQ(nastran(3), "3.");
  EXPECT_EQ(nastran(-1e-7), "-1.-7");
  EXPECT_EQ(nastran(1.0 / 3), ".333333333333333");
  EXPECT_EQ(nastran(-1.2345678901234567e12), "-1234567890123.5");
  EXPECT_EQ(nastran(1.2345678901234567e-12), "1.23456789012-12");
}

/// Half a unit of the last of 9 digits, which is the least that 16 characters hold.
TEST(ShortReal, ReadsBackNear) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double mantissa = std::uniform_real_distribution(-10.0, 10.0)(random);
    const double value =
        mantissa * std::pow(10.0, std::uniform_int_distribution(-300, 300)(random));
    for (const RealStyle style : {RealStyle::Plain, RealStyle::Nastran}) {
      const ShortReal real(value, 16, style);
      EXPECT_LE(real.text().size(), 16U);
      EXPECT_NEAR(real.value(), value, 5e-9 * std::abs(value)) << real.text();
    }
    EXPECT_EQ(ShortReal(value, 24, RealStyle::Plain).value(), value);
  }
}

}  // namespace
}  // namespace surfmesh
