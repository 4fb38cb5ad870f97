// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/segment_counts.hh"

#include <gtest/gtest.h>

#include <numbers>

#include "support/models.hh"
#include "surfmesh/boundary/segment_shape.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::contour_index;
using testing::model_of;

int least(const Model& model, const char* name) {
  return LeastSegments(model)(model.contour(contour_index(model, name)));
}

TEST(LeastSegments, AreOneForASideOfItsOwn) {
  EXPECT_EQ(least(model_of({testing::rectangle(0, 0, 1, 1)}), "p0:v0"), 1);
}

TEST(LeastSegments, AreThreeForAClosedContour) {
  EXPECT_EQ(least(testing::square_with_hole(0.5), "hole"), 3);
}

TEST(LeastSegments, AreTwoBesideAnotherContourOfTheSameVertices) {
  const Model model = model_of({testing::cylinder(0, pi), testing::cylinder(pi, 2 * pi)});
  EXPECT_EQ(least(model, "p0:v0"), 2);
  EXPECT_EQ(least(model, "p0:u0"), 1);
}

TEST(LeastSegments, LeaveOneToSpareBesideEachPole) {
  EXPECT_EQ(least(model_of({testing::sphere()}), "p0:u1"), 3);
  const auto cap = std::make_shared<test::Sphere>(1, Domain{0, 2 * pi, 0, pi / 2});
  EXPECT_EQ(least(model_of({cap}), "p0:u1"), 2);
}

TEST(RoundedUp, IsTheLeastMultipleNotBelow) {
  EXPECT_EQ(rounded_up(7, 1), 7);
  EXPECT_EQ(rounded_up(7, 4), 8);
  EXPECT_EQ(rounded_up(8, 4), 8);
}

/// The upper rim of a half cylinder of radius 1, of which n segments have a sag of 1 − cos(π/2n).
struct Rim {
  Model model = model_of({testing::cylinder(0, pi)});
  const ContourUse& use = model.contour(contour_index(model, "p0:v1")).uses.front();

  int count(double size, const SegmentBounds& bounds) const {
    const testing::FunctionField field = testing::isotropic_field_on(model.surface(use), size);
    return segments_for_sag(model.surface(use), *use.curve, MetricArc(*use.curve, field), bounds);
  }
};

TEST(SegmentsForSag, AreTheLeastThatHoldIt) {
  const Rim rim;
  // Lengths ask for 3, which make a sag of 0.134; 6 make 0.034, and 5 make 0.049.
  EXPECT_EQ(rim.count(pi / 3, {1, 1, 0.036}), 6);
  EXPECT_EQ(rim.count(pi / 3, {1, 4, 0.036}), 8);
}

TEST(SegmentsForSag, AreNotFewerThanLengthOrLeastAskFor) {
  const Rim rim;
  EXPECT_EQ(rim.count(pi / 10, {1, 1, 1}), 8);  // 0.71 of ten
  EXPECT_EQ(rim.count(pi / 10, {12, 1, 1}), 12);
}

TEST(SegmentsForSag, AreMoreByAFactor) {
  const Rim rim;
  EXPECT_EQ(rim.count(pi / 10, {1, 1, 1, 1.5}), 12);
  // The sag takes 6, where the length asks for 3: the factor counts from there.
  EXPECT_EQ(rim.count(pi / 3, {1, 1, 0.036, 1.5}), 9);
  EXPECT_EQ(rim.count(pi / 10, {1, 4, 1, 1.2}), 12);
}

TEST(SegmentsForSag, AreNotFlatByAFactor) {
  const Rim rim;
  EXPECT_EQ(rim.count(pi / 3, {1, 1, 0.036, 3}), 9);
  EXPECT_NEAR(rim.count(pi / 3, {1, 1, 1e-6, 3}), 12, 1);
}

TEST(SegmentsForSag, AreAtMostFourTimesTheLength) {
  EXPECT_NEAR(Rim().count(pi / 3, {1, 1, 1e-6}), 12, 1);
}

}  // namespace
}  // namespace surfmesh
