// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_key.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pictures/svg.hh"

namespace surfmesh {
namespace {

std::vector<std::string> texts(const ColourScale& scale) {
  std::vector<std::string> result;
  for (const ScaleTick& tick : scale_ticks(scale)) result.push_back(tick.text);
  return result;
}

using Texts = std::vector<std::string>;

TEST(ScaleTicks, AreRoundNumbers) {
  EXPECT_EQ(texts({ColourMap::Goodness, 0, 1, false}),
            (Texts{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(texts({ColourMap::Deviations, 3, 9, false}),
            (Texts{"3", "4", "5", "6", "7", "8", "9"}));
  EXPECT_EQ(texts({ColourMap::Amounts, 0, 0.00331, false}),
            (Texts{"0", "0.001", "0.002", "0.003"}));
}

TEST(ScaleTicks, OfLogarithmsAreOneTwoFive) {
  EXPECT_EQ(texts({ColourMap::Deviations, 0.5, 2, true}), (Texts{"0.5", "1", "2"}));
  EXPECT_EQ(texts({ColourMap::Amounts, 0.013, 0.55, true}),
            (Texts{"0.02", "0.05", "0.1", "0.2", "0.5"}));
  EXPECT_EQ(texts({ColourMap::Amounts, 1, 1000, true}),
            (Texts{"1", "3", "10", "30", "100", "300", "1000"}));
  EXPECT_EQ(texts({ColourMap::Amounts, 1.02, 1.31, true}).front(), "1.05");
}

TEST(ScaleTicks, LieWhereTheirValuesAre) {
  for (const ColourScale& scale :
       {ColourScale{ColourMap::Amounts, 0.1, 10, true}, ColourScale{ColourMap::Amounts, 2, 7}}) {
    for (const ScaleTick& tick : scale_ticks(scale)) {
      EXPECT_NEAR(tick.share, scale.share(std::stod(tick.text)), 1e-9);
    }
  }
}

TEST(ScaleTicks, OfOneValueAreThatValue) {
  EXPECT_EQ(texts({ColourMap::Amounts, 0, 0, false}), Texts{"0"});
  EXPECT_EQ(texts({ColourMap::Amounts, 0.3, 0.3, true}), Texts{"0.3"});
}

std::string drawn(const PictureKey& key, double height) {
  Svg svg(200, height);
  draw_key(svg, key, {{0, 0}, 200, height}, 10);
  return svg.text();
}

TEST(PictureKey, HasNumbersAndATitle) {
  const std::string text =
      drawn({"quality in the metric", ColourScale{ColourMap::Goodness, 0, 1, false}}, 300);
  EXPECT_NE(text.find(">quality in the<"), std::string::npos) << "broken at a blank";
  EXPECT_NE(text.find(">metric<"), std::string::npos);
  EXPECT_NE(text.find(">0.2<"), std::string::npos);
  const std::string best = hex(colour_at(ColourMap::Goodness, 95.5 / 96));
  EXPECT_NE(text.find(best), std::string::npos) << "the uppermost of 96 steps";
}

TEST(PictureKey, HasAsManyNamesAsFit) {
  PictureKey key{"patch"};
  for (int i = 0; i < 40; ++i) key.names.emplace_back(fmt::format("face{}", i), Rgb{});
  const std::string text = drawn(key, 200);
  EXPECT_NE(text.find(">face0<"), std::string::npos);
  EXPECT_EQ(text.find(">face39<"), std::string::npos);
  EXPECT_NE(text.find(" more<"), std::string::npos);
  EXPECT_NE(drawn(key, 900).find(">face39<"), std::string::npos);
}

TEST(PictureKey, CutsLongNamesBetweenSigns) {
  PictureKey key{"patch"};
  key.names.emplace_back("\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4\u00e4",
                         Rgb{});
  EXPECT_NE(drawn(key, 200).find("\u00e4...<"), std::string::npos);
}

TEST(PictureKey, OfNothingTakesNoRoom) {
  EXPECT_EQ(key_width({}, 10), 0);
  EXPECT_EQ(drawn({}, 50), Svg(200, 50).text());
  EXPECT_GT(key_width({"quality", ColourScale{}}, 10), 20);
}

}  // namespace
}  // namespace surfmesh
