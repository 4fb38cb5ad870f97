// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/uncrossing.hh"

#include <gtest/gtest.h>

#include <string_view>
#include <utility>

#include "support/models.hh"

namespace surfmesh {
namespace {

/// A model and its contours in segments, closed ones in three each.
struct RoughlyDivided {
  explicit RoughlyDivided(Model divided) : model(std::move(divided)), fields(model, 10) {
    for (const Contour& contour : model.contours) {
      ContourDivision& division = divisions.emplace_back().emplace(model, contour, fields, context);
      division.divide(contour.start == contour.end ? 3 : 1, 1, {});
    }
  }

  const ContourDivision& of(std::string_view name) const {
    return *divisions[static_cast<std::size_t>(testing::contour_index(model, name))];
  }

  Model model;
  RunContext context;
  testing::UniformSizes fields;
  ContourDivisions divisions;
};

TEST(Uncrossing, LeavesLoopsThatDoNotCrossAsTheyAre) {
  RoughlyDivided plate(testing::square_with_hole(0.5));
  uncross(plate.model, plate.divisions, 1);
  EXPECT_EQ(plate.of("hole").segment_count(), 3u);
  EXPECT_EQ(plate.of("p0:v0").segment_count(), 1u);
}

TEST(Uncrossing, HalvesSegmentsThatCross) {
  for (const int multiple : {1, 2}) {
    RoughlyDivided ring(testing::narrow_ring(0.9));
    uncross(ring.model, ring.divisions, multiple);
    for (const char* name : {"outer", "hole"}) {
      EXPECT_GT(ring.of(name).segment_count(), 3u);
      EXPECT_EQ(ring.of(name).segment_count() % static_cast<std::size_t>(multiple), 0u);
    }
  }
}

TEST(Uncrossing, LeavesNodesWhereItDoesNotSucceed) {
  // The hole touches the sides.
  RoughlyDivided plate(testing::square_with_hole(1));
  const auto before = plate.of("hole").parameters();
  uncross(plate.model, plate.divisions, 1);
  EXPECT_EQ(plate.of("hole").parameters(), before);
}

}  // namespace
}  // namespace surfmesh
