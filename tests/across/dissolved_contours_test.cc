// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/dissolved_contours.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/models.hh"

namespace surfmesh {
namespace {

/// Three unit squares in a row.
Model three_squares() {
  return testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1),
                            testing::rectangle(2, 0, 3, 1)});
}

/// The contour between two patches.
int contour_between(const Model& model, int a, int b) {
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const auto& uses = model.contours[c].uses;
    if (uses.size() == 2 && std::minmax(uses[0].patch, uses[1].patch) == std::minmax(a, b)) {
      return static_cast<int>(c);
    }
  }
  return -1;
}

long count(const std::vector<char>& flags) { return std::ranges::count(flags, 1); }

bool is_dissolved(const Model& model, int a, int b) {
  return dissolved_contours(model)[static_cast<std::size_t>(contour_between(model, a, b))] != 0;
}

TEST(DissolvedContours, AreThoseBetweenSmoothPatches) {
  const Model model = three_squares();
  EXPECT_EQ(count(dissolved_contours(model)), 2);
  EXPECT_TRUE(is_dissolved(model, 0, 1));
  EXPECT_TRUE(is_dissolved(model, 1, 2));
}

TEST(DissolvedContours, AreNotBetweenGroups) {
  Model model = three_squares();
  model.groups = {{"left", {0, 1}}, {"right", {2}}};
  EXPECT_TRUE(is_dissolved(model, 0, 1));
  EXPECT_FALSE(is_dissolved(model, 1, 2));
}

TEST(DissolvedContours, AreNotNamed) {
  Model model = three_squares();
  model.contour(contour_between(model, 0, 1)).is_named = true;
  EXPECT_FALSE(is_dissolved(model, 0, 1));
  EXPECT_TRUE(is_dissolved(model, 1, 2));
}

TEST(DissolvedContours, AreNotCreasesNorPoles) {
  const testing::Shape wall = std::make_shared<test::PlanePatch>(Vec3::Zero(), Vec3::UnitY(),
                                                                 Vec3::UnitZ(), Domain{0, 1, 0, 1});
  EXPECT_EQ(count(dissolved_contours(testing::model_of({testing::rectangle(0, 0, 1, 1), wall}))),
            0);
  const Model ball = testing::model_of({testing::sphere()});
  const std::vector<char> flags = dissolved_contours(ball);
  for (std::size_t c = 0; c < flags.size(); ++c) {
    EXPECT_EQ(flags[c] != 0, !ball.contours[c].is_degenerate) << "only the seam";
  }
}

}  // namespace
}  // namespace surfmesh
