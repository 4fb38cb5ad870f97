// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/pin_ends.hh"

#include <gtest/gtest.h>

#include "model/hand_made.hh"

namespace surfmesh {
namespace {

using testing::HandMade;
using testing::rectangle;

constexpr double kRounding = 1e-13;

/// A unit square whose first side ends a little before its corner.
Model square_with_gap(double gap) {
  HandMade made;
  const int patch = made.add_patch(rectangle(0, 0, 1, 1));
  made.add_loop(patch, made.corners_at({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  made.model.contour(0).uses[0].curve = std::make_shared<CallableCurve>([gap](double t) {
    return Uv{(1 - gap) * t, 0};
  });
  made.model.diagonal = 1.5;
  return made.model;
}

TEST(PinEnds, JoinsEndsThatFollowEachOtherExactly) {
  Model model = square_with_gap(kRounding);
  pin_ends(model);
  EXPECT_EQ(model.contour(0).uses[0].curve->evaluate(1),
            model.contour(1).uses[0].curve->evaluate(0));
}

TEST(PinEnds, StayOnSidesOfTheDomain) {
  Model model = square_with_gap(kRounding);
  pin_ends(model);
  EXPECT_EQ(model.contour(0).uses[0].curve->evaluate(1), (Uv{1, 0}));
}

TEST(PinEnds, SpreadTheDifferenceOverTheCurve) {
  Model model = square_with_gap(1e-3);
  model.contour(0).tolerance = 2e-3;
  pin_ends(model);
  const Curve& curve = *model.contour(0).uses[0].curve;
  EXPECT_EQ(curve.evaluate(0), (Uv{0, 0}));
  EXPECT_NEAR(curve.evaluate(0.5).u, 0.5, 1e-15);
}

TEST(PinEnds, LeaveGapsBeyondTheToleranceToTheCheck) {
  Model model = square_with_gap(1e-3);
  pin_ends(model);
  EXPECT_NEAR(model.contour(0).uses[0].curve->evaluate(1).u, 0.999, 1e-15);
}

}  // namespace
}  // namespace surfmesh
