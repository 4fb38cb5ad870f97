// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/segment_shape.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/models.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::contour_index;
using testing::model_of;

TEST(SegmentSag, IsThatOfAnArc) {
  const Model model = model_of({testing::cylinder(0, pi)});
  const ContourUse& use = model.contour(contour_index(model, "p0:v0")).uses.front();
  EXPECT_NEAR(segment_sag(model.surface(use), *use.curve, 0, 1), 1, 1e-14);
  EXPECT_NEAR(segment_sag(model.surface(use), *use.curve, 0.25, 0.5), 1 - std::cos(pi / 8), 1e-14);
}

TEST(SegmentSag, IsNothingOnAStraightLine) {
  const Model model = model_of({testing::cylinder(0, pi)});
  const ContourUse& use = model.contour(contour_index(model, "p0:u0")).uses.front();
  EXPECT_LT(segment_sag(model.surface(use), *use.curve, 0, 1), 1e-15);
}

/// A contour that passes the north pole of the unit sphere at a small distance.
ContourUse past_pole() {
  const auto curve = std::make_shared<CallableCurve>([](double t) {
    const double x = 2 * t - 1, y = 0.1;
    const double z = std::sqrt(2 - x * x - y * y);
    return Uv{std::atan2(y, x), std::atan2(z, std::hypot(x, y))};
  });
  return {0, curve, true, true};
}

TEST(MakesDetour, IsTrueOfALineAroundAPole) {
  // At constant latitude, while the contour passes straight by the pole.
  EXPECT_TRUE(makes_detour(model_of({testing::sphere()}), past_pole(), 0, 1));
}

TEST(MakesDetour, IsFalseOfShortSegments) {
  const Model model = model_of({testing::sphere()});
  EXPECT_FALSE(makes_detour(model, past_pole(), 0, 0.1));
  EXPECT_FALSE(makes_detour(model, past_pole(), 0.49, 0.51));
}

TEST(MakesDetour, IsFalseWhereTheLineIsTheContour) {
  const Model model = model_of({testing::cylinder(0, pi)});
  const ContourUse& use = model.contour(contour_index(model, "p0:v0")).uses.front();
  EXPECT_FALSE(makes_detour(model, use, 0, 1));
}

}  // namespace
}  // namespace surfmesh
