// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/formula_field.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"

namespace surfmesh {
namespace {

const UvBox kBox = {{0, 1}, {2, 3}};
const Eigen::AlignedBox3d kPositions(Vec3(10, 20, 30), Vec3(11, 22, 33));

TEST(FormulaField, HasBoundsOfItsSize) {
  const FieldSource field = formula_field("a*u+v+x+y-z", {{"a", 3}});
  ASSERT_TRUE(field.has_bounds());
  EXPECT_TRUE(field.uses_position);
  EXPECT_EQ(field.size({1, 2}, {10, 20, 30}), 5);
  EXPECT_EQ(field.size_bounds(kBox, kPositions), (Interval{-1, 9}));
}

TEST(FormulaField, HasBoundsOfItsMetric) {
  const FieldSource field = formula_field(std::array<std::string, 3>{"4", "u", "v+u"});
  ASSERT_TRUE(field.has_bounds());
  EXPECT_FALSE(field.uses_position);
  EXPECT_EQ(field.metric({1, 2}, Vec3::Zero()), (Metric{4, 1, 3}));
  const MetricBounds bounds = field.metric_bounds(kBox, {});
  EXPECT_EQ(bounds.m11, (Interval{4, 4}));
  EXPECT_EQ(bounds.m12, (Interval{0, 1}));
  EXPECT_EQ(bounds.m22, (Interval{2, 4}));
}

TEST(FormulaField, OfAConstantIsBoundedByIt) {
  const FieldSource field = formula_field("0.25");
  EXPECT_FALSE(field.uses_position);
  EXPECT_EQ(field.size_bounds(kBox, {}), (Interval{0.25, 0.25}));
}

TEST(FormulaField, RefusesWhatIsNoFormula) {
  EXPECT_NE(error_of([] { formula_field("2*w"); }).find("w"), std::string::npos);
}

TEST(FieldSource, OfACallableHasNoBounds) {
  FieldSource field;
  field.size = [](Uv, const Vec3&) { return 1.0; };
  EXPECT_FALSE(field.has_bounds());
}

}  // namespace
}  // namespace surfmesh
