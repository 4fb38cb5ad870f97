// SPDX-License-Identifier: BSD-3-Clause
// Sources of all kinds in the field of a patch.
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/tensors.hh"
#include "support/waves.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/place_sources.hh"
#include "surfmesh/sizes/point_nodes.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::size_of;
using testing::units;

const test::PlanePatch kWidePlane(Vec3::Zero(), {2, 0, 0}, {0, 1, 0});

/// Sizes from 0.001 to 1 without curvature.
Sizing sizing_with_grade(double grade = 0) {
  Sizing result = testing::sizing_of(0, 0.001, 1, 2);
  result.grade = grade;
  return result;
}

SizeField field_of(const PatchSources& sources, double grade = 0) {
  return SizeField(kWidePlane, resolve(sizing_with_grade(grade), 1), sources);
}

std::string error_at(const PatchSources& sources, Uv uv) {
  return error_of([&] { field_of(sources).at(uv); });
}

std::vector<std::shared_ptr<const Curve>> line(Uv a, Uv b) {
  return {std::make_shared<SegmentCurve>(a, b)};
}

TEST(FieldSources, AtAPointHoldInADisc) {
  const PatchSources sources{
      {}, {{0, {0.5, 0.5}, size_of(0.1), units(0.2), Outer{size_of(0.5), units(0.4)}}}};
  const SizeField field = field_of(sources);
  expect_near(field.at({0.5, 0.65}).size, isotropic(0.1), 1e-12);
  expect_near(field.at({0.5, 0.9}).size, isotropic(0.3), 1e-12);
  expect_near(field.at({0.6, 0.5}).size, isotropic(0.1), 1e-12);
  expect_near(field.at({0.85, 0.5}).size, isotropic(1), 1e-12);
}

TEST(FieldSources, GrowByTheGrade) {
  const SizeField field = field_of({{}, {{0, {0.5, 0.5}, size_of(0.1)}}}, 1.5);
  EXPECT_NEAR(field.at({0.5, 0.9}).size.h11, 0.1 + 0.4 * std::log(1.5), 1e-12);
  EXPECT_NEAR(field.at({0.7, 0.5}).size.h11, 0.1 + 0.4 * std::log(1.5), 1e-12);
}

TEST(FieldSources, AlongACurveKeepTheirFrame) {
  PatchSources sources;
  sources.along.push_back({0, line({0, 0}, {1, 1}), {size_of(0.2, 0.1, 0.3), units(0.1)}});
  const SizeField field = field_of(sources);
  expect_near(field.at({0.5, 0.55}).size, size_tensor(0.2, 0.1, 0.3), 1e-12);
  expect_near(field.at({0.5, 0.8}).size, isotropic(1), 1e-12);
}

TEST(FieldSources, InsideAPolygonReachOutOfIt) {
  PatchSources sources;
  sources.inside.push_back({0, {{0.2, 0.2}, {0.6, 0.2}, {0.6, 0.6}, {0.2, 0.6}}, {size_of(0.1)}});
  const SizeField field = field_of(sources, 1.5);
  EXPECT_NEAR(field.at({0.4, 0.4}).size.h11, 0.1, 1e-12);
  EXPECT_NEAR(field.at({0.7, 0.4}).size.h11, 0.1 + 0.2 * std::log(1.5), 1e-9);
  EXPECT_NEAR(field_of(sources).at({0.7, 0.4}).size.h11, 1, 1e-12);
}

TEST(FieldSources, MayBeFormulasOfThePlace) {
  PatchSources sources;
  sources.fields.push_back(
      {0, [](Uv uv, const Vec3& p) { return 0.01 + 0.1 * uv.v + 0.1 * p.x(); }});
  EXPECT_NEAR(field_of(sources).at({0.25, 0.5}).size.h11, 0.11, 1e-12);
}

TEST(FieldSources, MayBeMetricsInTheParameters) {
  PatchSources sources;
  FieldSource source{.patch = 0};
  source.metric = [](Uv, const Vec3&) { return Metric{400, 0, 25}; };
  sources.fields.push_back(source);
  // A step of 0.05 in u is 0.1 long, one of 0.2 in v 0.2.
  expect_near(field_of(sources).at({0.3, 0.3}).size, {0.1, 0, 0.2}, 1e-12);
}

TEST(FieldSources, RefuseFieldsThatAreNotPositive) {
  PatchSources sources;
  sources.fields.push_back({0, [](Uv uv, const Vec3&) { return uv.u - 0.5; }});
  EXPECT_EQ(error_at(sources, {0.75, 0}), "no error");
  EXPECT_NE(error_at(sources, {0.25, 0.5}).find("at (u,v) = (0.25, 0.5) is not positive"),
            std::string::npos);
  sources.fields[0].size = [](Uv, const Vec3&) { return kUnset; };
  EXPECT_NE(error_at(sources, {0.25, 0.5}), "no error");
  sources.fields[0].metric = [](Uv, const Vec3&) { return Metric{1, 2, 1}; };
  EXPECT_NE(error_at(sources, {0.25, 0.5}).find("[1, 2, 1]"), std::string::npos);
}

TableSource table(double precision = 0.1) {
  TableSource source{0, {}, precision};
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const Uv uv{i / 19.0, j / 19.0};
      source.nodes.push_back({uv, size_of(0.05 * std::exp(uv.u))});
    }
  }
  return source;
}

TEST(FieldSources, MayBeTables) {
  PatchSources sources;
  sources.tables.push_back(table());
  const SizeField field = field_of(sources);
  for (const double u : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    const double exact = 0.05 * std::exp(u);
    EXPECT_NEAR(field.at({u, 0.3}).size.h11, exact, 0.1 * exact) << u;
  }
}

TEST(FieldSources, TakeTheMetricOfATableToSizes) {
  PatchSources sources;
  TableSource source{.patch = 0, .nodes = {}};
  source.nodes.push_back({{0.5, 0.5}, {}, {400, 0, 25}});
  sources.tables.push_back(source);
  expect_near(field_of(sources).at({0.9, 0.1}).size, {0.1, 0, 0.2}, 1e-12);
}

TEST(FieldSources, RefuseTablesOutsideTheDomain) {
  PatchSources sources;
  sources.tables.push_back({0, {{{1.5, 0.5}, size_of(1)}}});
  EXPECT_NE(error_at(sources, {0, 0}).find("(1.5, 0.5)"), std::string::npos);
  sources.tables[0].nodes.clear();
  EXPECT_NE(error_at(sources, {0, 0}).find("no rows"), std::string::npos);
}

TEST(FieldSources, AreClampedButNotLimitedByStretch) {
  const SizeField field = field_of({{}, {{0, {0.5, 0.5}, size_of(5, 1e-5), units(1)}}});
  expect_near(field.at({0.5, 0.5}).size, {1, 0, 0.001}, 1e-12);
}

TEST(FieldSources, InterpolatePointsThatAreAloneWithAPlace) {
  PatchSources sources{{}, {{0, {0, 0.5}, size_of(0.1)}, {0, {1, 0.5}, size_of(0.4)}}};
  sources.along.push_back({0, line({0.5, 0}, {0.5, 1}), {size_of(0.01), units(0.1)}});
  const SizeField field = field_of(sources);
  EXPECT_NEAR(field.at({0, 0}).size.h11, 0.1, 1e-12);
  EXPECT_NEAR(field.at({1, 1}).size.h11, 0.4, 1e-12);
  EXPECT_NEAR(field.at({0.5, 0.3}).size.h11, 0.01, 1e-12);
}

TEST(FieldSources, TellTheirPrecision) {
  PatchSources sources;
  EXPECT_FALSE(sources.precision());
  sources.tables.push_back(table(0.3));
  sources.fields.push_back({});
  EXPECT_EQ(*sources.precision(), 0.3);
  sources.fields.back().precision = 0.2;
  EXPECT_EQ(*sources.precision(), 0.2);
}

TEST(MakeControl, RepresentsSizesAroundAPlace) {
  PatchSources sources{{{0, size_of(0.3)}}, {{0, {0.5, 0.5}, size_of(0.02), units(0.1)}}};
  const SizeField field = field_of(sources, 1.5);
  ControlInput input =
      collect_control_input(kWidePlane, resolve(sizing_with_grade(1.5), 1), sources, {});
  const auto control = make_control(input);
  finish(*control);
  QueryHint hint;
  for (double u = 0; u <= 1; u += 0.03) {
    const SizeField::Sample exact = field.at({u, 0.4});
    const double size = control->size({{u, 0.4}, exact.point, exact.form}, hint).h11;
    EXPECT_NEAR(std::log(size / exact.size.h11), 0, 0.25) << u;
  }
}

TEST(PointNodes, HaveTheExtendedForms) {
  const std::vector<AtSource> sources = {
      {0, {0, 0}, size_of(0.1)},
      {0, {1, 0}, size_of(0.1), units(0.2)},
      {0, {1, 1}, size_of(0.1), units(0.2), Outer{size_of(0.5), units(0.4)}}};
  const auto nodes = point_nodes(sources, kWidePlane, resolve(sizing_with_grade(), 1).bounds);
  EXPECT_FALSE(std::isfinite(nodes[0].inner.h11));
  EXPECT_EQ(nodes[1].inner, isotropic(0.1));
  EXPECT_EQ(nodes[1].size, isotropic(0.1));
  EXPECT_EQ(nodes[1].radius, 0.2);
  EXPECT_EQ(nodes[2].inner, isotropic(0.1));
  EXPECT_EQ(nodes[2].size, isotropic(0.5));
  EXPECT_EQ(nodes[2].outer_radius, 0.4);
}

TEST(PointNodes, LieAlongACurveThatReachesNowhere) {
  PatchSources sources;
  sources.along.push_back({0, line({0, 0.5}, {1, 0.5}), {size_of(0.1)}});
  const auto nodes = field_nodes(sources, field_of(sources), false);
  EXPECT_NEAR(static_cast<double>(nodes.size()), 21, 2);
  for (const ControlNode& node : nodes) EXPECT_EQ(node.size, isotropic(0.1));
  EXPECT_TRUE(field_nodes(sources, field_of(sources, 1.5), true).empty());
}

TEST(PlaceSources, KnowWhatIsInAPolygon) {
  const std::vector<Uv> arrow = {{0, 0}, {2, 1}, {0, 2}, {1, 1}};
  EXPECT_TRUE(contains(arrow, {1.5, 1}));
  EXPECT_FALSE(contains(arrow, {0.5, 1}));
  EXPECT_FALSE(contains(arrow, {3, 1}));
  EXPECT_TRUE(contains(arrow, {0.5, 0.4}));
}

TEST(PlaceSources, RefuseWhatIsNoPlace) {
  std::vector<PlacedSize> sizes;
  const SizeBounds bounds = resolve(sizing_with_grade(), 1).bounds;
  EXPECT_THROW(add_near({{}, {size_of(1)}}, bounds, sizes), Error);
  EXPECT_THROW(add_near({{Vec3(kUnset, 0, 0)}, {size_of(1)}}, bounds, sizes), Error);
  EXPECT_THROW(add_near({{Vec3::Zero()}, {size_of(1), units(-1)}}, bounds, sizes), Error);
  EXPECT_THROW(add_border({0, {{0, 0}, {1, 1}}, {size_of(1)}}, kWidePlane, bounds, sizes), Error);
  EXPECT_THROW(add_border({0, {{0, 0}, {1, 1}, {2, 0}}, {size_of(1)}}, kWidePlane, bounds, sizes),
               Error);
}

TEST(SizeBounds, CountSizesBeyondThem) {
  Sources sources;
  sources.everywhere = {{0, size_of(0.5)}, {0, size_of(2)}, {1, size_of(2)}};  // a group's, once
  sources.at = {{0, {0, 0}, size_of(0.5, 1e-9), {}, Outer{size_of(7), units(1)}}};
  EXPECT_EQ(count_clamped(sources, resolve(sizing_with_grade(), 1).bounds), 3u);
}

TEST(SizeBounds, CountRowsOfTablesBeyondThem) {
  const SizeBounds bounds = resolve(sizing_with_grade(), 1).bounds;
  const TableSource sizes = {0, {{{0, 0}, size_of(3)}, {{0, 0}, size_of(1)}}};
  EXPECT_EQ(count_clamped(sizes, kWidePlane, bounds), 1u);
  // Lengths along u of 3, 1 (at the bound) and 0.5, where u is half of x.
  const TableSource metrics = {
      0, {{{0, 0}, {}, {4.0 / 9, 0, 1}}, {{1, 0}, {}, {4, 0, 1}}, {{1, 1}, {}, {16, 0, 4}}}};
  EXPECT_EQ(count_clamped(metrics, kWidePlane, bounds), 1u);
}

}  // namespace
}  // namespace surfmesh
