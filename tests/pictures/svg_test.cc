// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/svg.hh"

#include <gtest/gtest.h>

namespace surfmesh {
namespace {

TEST(Svg, IsAWhitePictureOfItsSize) {
  const std::string text = Svg(300, 200).text();
  EXPECT_TRUE(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\""));
  EXPECT_NE(text.find("viewBox=\"0 0 300 200\""), std::string::npos);
  EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(Svg, GivesPolygonsAsShortSteps) {
  Svg svg(10, 10);
  svg.add_polygons({{{1, 2}, {1.5, 2}, {0.5, 2.25}}, {}, {{3, 3}, {4, 3}, {4, 4.5}}},
                   {"#ffffff", "#000000", 0.5});
  // The second begins at a step from the first corner of the first.
  EXPECT_NE(svg.text().find("d=\"m1 2l.5 0-1 .3zm2 1l1 0 0 1.5z\""), std::string::npos)
      << svg.text();
}

TEST(Svg, LeavesLinesOpenAndGoesOnFromTheirEnd) {
  Svg svg(10, 10);
  svg.add_lines({{{0, 0}, {1, -1}}, {{2, 0}, {-2.5, 0.04}}}, {"none", "#000000", 1});
  EXPECT_NE(svg.text().find("fill=\"none\""), std::string::npos);
  EXPECT_NE(svg.text().find("d=\"m0 0l1-1m1 1l-4.5 0\""), std::string::npos) << svg.text();
}

TEST(Svg, DoesNotAddUpRounding) {
  Svg svg(100, 10);
  std::vector<PicturePoint> line;
  for (int i = 0; i <= 900; ++i) line.push_back({i / 9.0, 0});
  svg.add_lines({line}, {"none", "#000000", 1});
  double x = 0;
  const std::string text = svg.text();
  const std::size_t from = text.find("l.1 0") + 1;
  for (std::size_t at = from; at < text.find('"', from);) {
    std::size_t used = 0;
    x += std::stod(text.substr(at), &used);
    at += used;
    at += text.substr(at).starts_with(" 0 ") ? 3 : 2;
  }
  EXPECT_NEAR(x, 100, 0.05);
}

TEST(Svg, WritesTextThatMayHoldAnySign) {
  Svg svg(10, 10);
  svg.add_text({1, 2}, "a < b & c", 8, TextAnchor::Middle);
  EXPECT_NE(svg.text().find("text-anchor=\"middle\">a &lt; b &amp; c</text>"), std::string::npos);
}

TEST(Svg, IsXmlWhateverTextHolds) {
  Svg svg(10, 10);
  svg.add_text({1, 2}, "caf\xE9\x02<", 8);
  EXPECT_NE(svg.text().find(">caf\xEF\xBF\xBD\xEF\xBF\xBD&lt;</text>"), std::string::npos)
      << svg.text();
}

TEST(Svg, MayHaveNoBackground) {
  EXPECT_EQ(Svg(10, 10, "none").text().find("<rect"), std::string::npos);
}

TEST(Svg, CutsOffWhatIsOutsideOfAFrame) {
  Svg svg(100, 50);
  svg.begin_frame({{10, 0}, 60, 50});
  svg.end_frame();
  EXPECT_NE(svg.text().find("<svg x=\"10.0\" y=\"0.0\" width=\"60.0\" height=\"50.0\" "
                            "viewBox=\"10.0 0.0 60.0 50.0\">\n</svg>"),
            std::string::npos)
      << svg.text();
}

TEST(Svg, NamesTheColourOfFacesOnce) {
  Svg svg(10, 10);
  svg.begin_faces();
  svg.add_faces({{{0, 0}, {1, 0}, {0, 1}}}, "#123456");
  svg.end_faces();
  EXPECT_NE(svg.text().find("<path color=\"#123456\" d=\"m0 0l1 0-1 1z\"/>"), std::string::npos)
      << svg.text();
}

TEST(Svg, GivesLinesTheirOpacity) {
  Svg svg(10, 10);
  svg.add_lines({{{0, 0}, {1, 1}}}, {"none", "#000000", 1, 0.25});
  EXPECT_NE(svg.text().find("stroke-opacity=\"0.25\""), std::string::npos);
}

TEST(Svg, HasGreysFromBlackToWhite) {
  EXPECT_EQ(grey(0), "#000000");
  EXPECT_EQ(grey(0.5), "#808080");
  EXPECT_EQ(grey(7), "#ffffff");
}

}  // namespace
}  // namespace surfmesh
