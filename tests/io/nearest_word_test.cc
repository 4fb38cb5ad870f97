// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/nearest_word.hh"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace surfmesh {
namespace {

constexpr std::array<std::string_view, 4> kWords = {"curvature", "hmin", "hmax", "stretch"};

TEST(NearestWord, MendsAMisspeltLetter) {
  EXPECT_EQ(nearest_word("curvatrue", kWords), "curvature");
  EXPECT_EQ(nearest_word("strech", kWords), "stretch");
  EXPECT_EQ(nearest_word("hmni", kWords), "hmin");
}

TEST(NearestWord, PrefersTheNearerOne) {
  EXPECT_EQ(nearest_word("hmix", kWords), "hmin");
  EXPECT_EQ(nearest_word("hmx", kWords), "hmax");
}

TEST(NearestWord, SaysNothingOfFarWords) {
  EXPECT_EQ(nearest_word("radius", kWords), std::nullopt);
  EXPECT_EQ(nearest_word("", kWords), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(1000, 'h'), kWords), std::nullopt);
  EXPECT_EQ(nearest_word("hmin", {}), std::nullopt);
  EXPECT_EQ(nearest_word("w", std::array<std::string_view, 2>{"x", "y"}), std::nullopt);
}

}  // namespace
}  // namespace surfmesh
