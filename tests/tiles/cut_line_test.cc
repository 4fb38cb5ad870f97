// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/tiles/cut_line.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/models.hh"
#include "tiles/flat_polygons.hh"

namespace surfmesh::detail {
namespace {

using testing::area_of;
using testing::FlatPolygon;
using testing::with_unit_sides;

constexpr int kAlongU = 0, kAlongV = 1;

/// Divides in the plane, where a unit of length is a unit.
class Divider {
 public:
  std::vector<TilePolygon> operator()(FlatPolygon& polygon, int axis, double value) {
    return divide_at(polygon.sides, polygon.nodes, axis, value, rules, queries);
  }

  testing::Shape plane = testing::rectangle(-100, -100, 100, 100);
  testing::FunctionField field = testing::isotropic_field(1);
  CutRules rules{*plane, field};
  QueryCounts queries;
};

/// Expect two parts and the area of the whole.
void expect_divided(FlatPolygon polygon, int axis, double value, std::size_t parts = 2) {
  const double area = area_of(polygon.sides, polygon.nodes);
  const auto divided = Divider()(polygon, axis, value);
  ASSERT_EQ(divided.size(), parts);
  double sum = 0;
  for (const TilePolygon& part : divided) sum += area_of(part, polygon.nodes);
  EXPECT_NEAR(sum, area, 1e-12 * area);
}

/// Expect no parts, and no new nodes.
void expect_refused(FlatPolygon polygon, int axis, double value) {
  const std::size_t nodes = polygon.nodes.size();
  EXPECT_TRUE(Divider()(polygon, axis, value).empty());
  EXPECT_EQ(polygon.nodes.size(), nodes);
}

FlatPolygon box(double width, double height) {
  return {with_unit_sides({{0, 0}, {width, 0}, {width, height}, {0, height}})};
}

TEST(DivideAt, CutsASquareInTwo) {
  for (const int axis : {kAlongU, kAlongV}) expect_divided(box(10, 10), axis, 5);
}

TEST(DivideAt, PlacesNodesAUnitApart) {
  FlatPolygon square = box(10, 10);
  const std::size_t before = square.nodes.size();
  ASSERT_EQ(Divider()(square, kAlongU, 5.2).size(), 2u);
  ASSERT_EQ(square.nodes.size(), before + 9);
  for (std::size_t i = 0; i < 9; ++i) {
    const TileNode& node = square.nodes[before + i];
    EXPECT_NEAR(node.uv.u, 5, 1e-12);
    EXPECT_NEAR(node.uv.v, static_cast<double>(i + 1), 1e-9);
    EXPECT_EQ(node.vertex, -1);
    EXPECT_TRUE(node.can_end_cut);
  }
}

TEST(DivideAt, FollowsTheMetricAlongTheCut) {
  FlatPolygon square = box(10, 10);
  const std::size_t before = square.nodes.size();
  const testing::FunctionField growing =
      testing::isotropic_field([](Uv uv) { return 1 + 0.1 * uv.v; });
  QueryCounts queries;
  const testing::Shape plane = testing::rectangle(0, 0, 10, 10);
  ASSERT_EQ(divide_at(square.sides, square.nodes, kAlongU, 5, {*plane, growing}, queries).size(),
            2u);
  // ∫ dv / (1 + v/10) over 10 is 10 ln 2 = 6.93: seven segments.
  ASSERT_EQ(square.nodes.size(), before + 6);
  for (int i = 1; i < 7; ++i) {
    const double expected = 10 * (std::pow(2.0, i / 7.0) - 1);
    EXPECT_NEAR(square.nodes[before + static_cast<std::size_t>(i) - 1].uv.v, expected, 0.01);
  }
  EXPECT_EQ(queries.total(), growing.queries());
  EXPECT_LT(queries.total(), 100u);
}

TEST(DivideAt, TakesThreeSegmentsAtLeast) {
  FlatPolygon strip = box(20, 2.6);
  const std::size_t before = strip.nodes.size();
  ASSERT_EQ(Divider()(strip, kAlongU, 10).size(), 2u);
  EXPECT_EQ(strip.nodes.size(), before + 2);
}

TEST(DivideAt, CutsBothSidesOfAHole) {
  const FlatPolygon holed{{with_unit_sides({{0, 0}, {12, 0}, {12, 12}, {0, 12}}),
                           with_unit_sides({{4, 4}, {4, 8}, {8, 8}, {8, 4}})}};
  expect_divided(holed, kAlongU, 6);
  expect_divided(holed, kAlongV, 6);
}

TEST(DivideAt, LeavesAHoleBesideTheLineWhole) {
  FlatPolygon holed{{with_unit_sides({{0, 0}, {12, 0}, {12, 12}, {0, 12}}),
                     with_unit_sides({{6, 4}, {6, 8}, {10, 8}, {10, 4}})}};
  const auto parts = Divider()(holed, kAlongU, 3);
  ASSERT_EQ(parts.size(), 2u);
  const std::size_t holes = parts[0].loops.size() + parts[1].loops.size() - 2;
  EXPECT_EQ(holes, 1u);
}

TEST(DivideAt, MakesThreePartsOfAU) {
  expect_divided(
      {with_unit_sides({{0, 0}, {12, 0}, {12, 10}, {8, 10}, {8, 4}, {4, 4}, {4, 10}, {0, 10}})},
      kAlongV, 7, 3);
}

// --- what is refused ---

TEST(DivideAt, RefusesShortCuts) {
  expect_refused(box(20, 2.4), kAlongU, 10);
  expect_divided(box(20, 2.6), kAlongU, 10);
}

TEST(DivideAt, RefusesToComeNearANode) {
  const auto with_hole_at = [](double u) {
    return FlatPolygon{{with_unit_sides({{0, 0}, {12, 0}, {12, 12}, {0, 12}}),
                        with_unit_sides({{u, 6}, {u + 2, 8}, {u + 2, 4}})}};
  };
  expect_refused(with_hole_at(5.55), kAlongU, 5);
  expect_divided(with_hole_at(5.65), kAlongU, 5);
}

TEST(DivideAt, RefusesToCrossASide) {
  // The line passes on the right of the hole; the cut, from the nearest node below, on its left.
  const std::vector<Uv> outer = {{-8, 0}, {0, 0}, {10, 0}, {10, 10}, {4, 10}, {-8, 10}};
  const auto with_hole_from = [&outer](double u) {
    return FlatPolygon{{outer, {{u, 4}, {u + 0.2, 5.5}, {u + 2.2, 4}}}};
  };
  expect_refused(with_hole_from(0.8), kAlongU, 4);
  expect_divided(with_hole_from(-3), kAlongU, 4);
}

TEST(DivideAt, RefusesToMeetASideUnderASmallAngle) {
  const auto with_roof_to = [](double v) {
    return FlatPolygon{with_unit_sides({{0, 0}, {10, 0}, {10, 10}, {0, v}})};
  };
  // 10 by 12 is 40° against the cut, 10 by 13 is 38°.
  expect_divided(with_roof_to(22), kAlongU, 5);
  expect_refused(with_roof_to(23), kAlongU, 5);
}

TEST(DivideAt, MeasuresAnglesInTheMetric) {
  const std::vector<Uv> corners = {{0, 0}, {10, 0}, {10, 10}, {0, 25}};
  // Where v is half as long, the roof is flat enough.
  const testing::FunctionField flat = testing::constant_field({1, 0, 0.25});
  FlatPolygon polygon{with_unit_sides(corners)};
  Divider divide;
  EXPECT_TRUE(divide(polygon, kAlongU, 5).empty());
  const CutRules rules{*divide.plane, flat};
  EXPECT_EQ(divide_at(polygon.sides, polygon.nodes, kAlongU, 5, rules, divide.queries).size(), 2u);
}

TEST(DivideAt, RefusesALineThatMissesThePolygon) {
  expect_refused(box(10, 10), kAlongU, -1);
  expect_refused(box(10, 10), kAlongV, 10.5);
}

TEST(DivideAt, RefusesALineThatOnlyCutsACornerOff) {
  expect_refused({with_unit_sides({{0, 0}, {7, -7}, {14, 0}, {7, 7}})}, kAlongU, 0.3);
}

TEST(DivideAt, RefusesCutsThatEndInOneNode) {
  const FlatPolygon holed{
      {with_unit_sides({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), {{5.1, 5}, {3, 4.4}, {3, 5.6}}}};
  expect_refused(holed, kAlongU, 5);
  expect_divided(holed, kAlongU, 3.9);
}

TEST(DivideAt, RefusesToReachAHoleFromOneSideAlone) {
  // Beyond the hole there is one unit, which is too short to be cut.
  const FlatPolygon holed{{with_unit_sides({{0, 0}, {12, 0}, {12, 12}, {0, 12}}),
                           with_unit_sides({{4, 4}, {4, 11}, {8, 11}, {8, 4}})}};
  expect_refused(holed, kAlongU, 6);
}

// --- demands ---

TEST(DivideAt, MakesSidesEvenInSumForQuads) {
  for (const double height : {3.0, 4.0, 6.6, 7.4, 10.0, 11.0}) {
    for (const double at : {4.0, 5.0, 6.2, 7.0}) {
      FlatPolygon polygon{with_unit_sides({{0, 0}, {12, 0}, {12, height}, {0, height}})};
      ASSERT_EQ(polygon.sides.side_count() % 2, 0u);
      Divider divide;
      divide.rules.multiple = 2;
      const auto parts = divide(polygon, kAlongU, at);
      ASSERT_EQ(parts.size(), 2u);
      for (const TilePolygon& part : parts) EXPECT_EQ(part.side_count() % 2, 0u);
    }
  }
}

TEST(DivideAt, MakesSidesEvenAroundHolesAndInThreeParts) {
  const auto hole = with_unit_sides({{4, 4}, {4, 8}, {8, 8}, {8, 4}});
  const FlatPolygon holed{{with_unit_sides({{0, 0}, {12, 0}, {12, 11}, {0, 11}}), hole}};
  const FlatPolygon forked{
      with_unit_sides({{0, 0}, {13, 0}, {13, 10}, {9, 10}, {9, 4}, {4, 4}, {4, 10}, {0, 10}})};
  for (const FlatPolygon& given : {holed, forked}) {
    ASSERT_EQ(given.sides.side_count() % 2, 0u);
    for (const int axis : {kAlongU, kAlongV}) {
      FlatPolygon polygon = given;
      Divider divide;
      divide.rules.multiple = 2;
      const auto parts = divide(polygon, axis, 6.3);
      EXPECT_GE(parts.size(), 2u);
      for (const TilePolygon& part : parts) EXPECT_EQ(part.side_count() % 2, 0u);
    }
  }
}

TEST(DivideAt, HoldsTheSag) {
  // Across the axis, segments of length s have the sag 1 − cos(s/2).
  constexpr double height = 8;
  const testing::Shape cylinder = std::make_shared<test::Cylinder>(1, Domain{0, 4, 0, height});
  const testing::FunctionField field = testing::isotropic_field_on(*cylinder, 1);
  for (const double sag : {0.05, 0.02, 0.01}) {
    FlatPolygon polygon{with_unit_sides({{0, 0}, {4, 0}, {4, height}, {0, height}})};
    const std::size_t before = polygon.nodes.size();
    QueryCounts queries;
    const CutRules rules{*cylinder, field, 1, sag};
    const auto parts = divide_at(polygon.sides, polygon.nodes, kAlongV, 4, rules, queries);
    ASSERT_EQ(parts.size(), 2u);
    const std::size_t segments = polygon.nodes.size() - before + 1;
    const double step = 4 / static_cast<double>(segments);
    EXPECT_LE(1 - std::cos(step / 2), sag);
    // Some room is left for what lies between samples.
    const double longer = 4 / static_cast<double>(segments - 1);
    EXPECT_GT(1 - std::cos(longer / 2), 0.94 * sag);
  }
}

}  // namespace
}  // namespace surfmesh::detail
