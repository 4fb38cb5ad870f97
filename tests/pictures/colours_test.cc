// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/colours.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace surfmesh {
namespace {

TEST(Colours, AreInterpolatedBetweenStops) {
  for (const ColourMap map : {ColourMap::Amounts, ColourMap::Goodness, ColourMap::Deviations}) {
    EXPECT_EQ(hex(colour_at(map, -1)), hex(stops(map).front()));
    EXPECT_EQ(hex(colour_at(map, 2)), hex(stops(map).back()));
    const Rgb half = colour_at(map, 0.5 / static_cast<double>(stops(map).size() - 1));
    EXPECT_NEAR(half.red, 0.5 * (stops(map)[0].red + stops(map)[1].red), 1e-12);
    EXPECT_EQ(hex(colour_at(map, NAN)), hex(kNoValueColour));
  }
}

TEST(Colours, OfCategoriesDiffer) {
  std::set<std::string> colours;
  for (std::size_t i = 0; i < 50; ++i) colours.insert(hex(category_colour(i)));
  EXPECT_EQ(colours.size(), 50u);
}

TEST(ColourScale, IsLogarithmicForSizes) {
  const ColourScale scale = scale_of(MeshField::Size, {1, 4, NAN, 16}, false);
  EXPECT_EQ(scale.from, 1);
  EXPECT_EQ(scale.to, 16);
  EXPECT_NEAR(scale.share(4), 0.5, 1e-12);
}

TEST(ColourScale, DoesNotShowRounding) {
  const ColourScale scale = scale_of(MeshField::Size, {0.5, 0.5 * (1 + 1e-14)}, false);
  EXPECT_NEAR(scale.share(0.5), 0.5, 1e-6);
  EXPECT_NEAR(scale.share(0.5 * (1 + 1e-14)), 0.5, 1e-6);
}

TEST(ColourScale, FollowsTheElements) {
  EXPECT_NEAR(scale_of(MeshField::Valence, {}, false).share(6), 0.5, 1e-12);
  EXPECT_NEAR(scale_of(MeshField::Valence, {}, true).share(4), 0.5, 1e-12);
  EXPECT_NEAR(scale_of(MeshField::Length, {}, true).share(1), 0.5, 1e-12);
}

}  // namespace
}  // namespace surfmesh
