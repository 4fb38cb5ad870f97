// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/image.hh"

#include <gtest/gtest.h>

#include <array>

#include "pictures/stroke_font.hh"
#include "support/png_pixels.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using testing::PngPixel;
using testing::PngPixels;

TEST(Image, OfNothingLetsThrough) {
  const PngPixels pixels(Image(20, 10).png());
  EXPECT_EQ(pixels.width(), 20U);
  EXPECT_EQ(pixels.height(), 10U);
  EXPECT_EQ(pixels.at(3, 3), (PngPixel{0, 0, 0, 0}));
}

TEST(Image, HasABackground) {
  Image image(20, 10);
  image.put_behind({1, 0.2, 0});
  EXPECT_EQ(PngPixels(image.png()).at(19, 9), (PngPixel{255, 51, 0, 255}));
}

TEST(Image, CoversPixelsOfPolygonsByTheirShare) {
  Image image(20, 10);
  image.put_behind({1, 1, 1});
  image.add_rectangle({2, 3}, 4.5, 2.25, {"#000000", "none", 0});
  const PngPixels pixels(image.png());
  EXPECT_EQ(pixels.at(2, 3), (PngPixel{0, 0, 0, 255}));
  EXPECT_EQ(pixels.at(1, 3), (PngPixel{255, 255, 255, 255}));
  EXPECT_EQ(pixels.at(6, 3)[0], 128);
  EXPECT_EQ(pixels.at(3, 5)[0], 191);
  EXPECT_EQ(pixels.at(3, 6)[0], 255);
}

TEST(Image, DrawsLinesOfTheirWidth) {
  for (const double width : {0.4, 1.0, 2.0, 5.0}) {
    Image image(40, 40);
    image.put_behind({1, 1, 1});
    image.add_lines({{{-5, 20.3}, {50, 20.3}}}, {"none", "#000000", width});
    const PngPixels pixels(image.png());
    double ink = 0;
    for (std::size_t y = 0; y < 40; ++y) ink += 1 - pixels.at(10, y)[0] / 255.0;
    EXPECT_NEAR(ink, width, 0.03 * width + 0.02);
  }
}

TEST(Image, DrawsLinesThatOverlapNoDarker) {
  Image image(20, 20);
  image.put_behind({1, 1, 1});
  const PicturePoints line = {{0, 10.5}, {20, 10.5}};
  image.add_lines({line, line, line}, {"none", "#000000", 1, 0.5});
  EXPECT_EQ(PngPixels(image.png()).at(5, 10)[0], 128);
}

TEST(Image, IsTheSameOnAnyNumberOfThreads) {
  const auto draw = [](int threads) {
    Image image(200, 200);
    with_threads(threads, [&] {
      for (int i = 0; i < 50; ++i) {
        image.add_lines({{{i * 3.1, 0}, {200 - i * 2.7, 200}}}, {"none", "#102030", 0.7, 0.6});
      }
    });
    return image.png();
  };
  EXPECT_EQ(draw(1), draw(2));
  EXPECT_EQ(draw(1), draw(4));
}

TEST(StrokeFont, HasAllSignsOfAscii) {
  for (char sign = '!'; sign <= '~'; ++sign) {
    const auto lines = text_lines(std::string(1, sign), 100);
    EXPECT_FALSE(lines.empty()) << sign;
    for (const auto& line : lines) {
      EXPECT_GE(line.size(), 2U) << sign;
      for (const PicturePoint& point : line) {
        EXPECT_GE(point.x, -3) << sign;
        EXPECT_LE(point.x, text_width(std::string(1, sign), 100) + 3) << sign;
        EXPECT_GE(point.y, -78) << sign;
        EXPECT_LE(point.y, 25) << sign;
      }
    }
  }
}

TEST(StrokeFont, MakesCapitalsAsHighAsFontsDo) {
  EXPECT_NEAR(text_lines("I", 100)[0][1].y, -72, 1);
  EXPECT_TRUE(text_lines(" ", 10).empty());
}

TEST(StrokeFont, ShowsAQuestionMarkForOtherSigns) {
  EXPECT_EQ(text_width("\u00e4", 10), text_width("?", 10));
  EXPECT_EQ(text_lines("a\u2211", 10).size(), text_lines("a?", 10).size());
}

TEST(StrokeFont, GrowsWithItsText) {
  EXPECT_EQ(text_width("", 10), 0);
  EXPECT_GT(text_width("mm", 10), text_width("m", 10) * 2);
  EXPECT_DOUBLE_EQ(text_width("abc", 20), 2 * text_width("abc", 10));
}

}  // namespace
}  // namespace surfmesh
