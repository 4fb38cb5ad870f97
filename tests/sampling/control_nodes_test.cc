// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/control_nodes.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/waves.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

using testing::sizing_of;

std::vector<ControlNode> nodes_on(const Surface& surface, const Sizing& sizing,
                                  const ControlNodeOptions& options = {}) {
  return choose_control_nodes(SizeField(surface, resolve(sizing, 1), {}), options).nodes;
}

std::set<std::pair<double, double>> positions(const std::vector<ControlNode>& nodes) {
  std::set<std::pair<double, double>> result;
  for (const ControlNode& node : nodes) result.insert({node.uv.u, node.uv.v});
  return result;
}

void expect_corners(const Domain& d, const std::vector<ControlNode>& nodes) {
  const auto all = positions(nodes);
  for (const double u : {d.u0, d.u1}) {
    for (const double v : {d.v0, d.v1}) EXPECT_TRUE(all.contains({u, v})) << u << " " << v;
  }
}

double least_size(const std::vector<ControlNode>& nodes) {
  double least = std::numeric_limits<double>::infinity();
  for (const ControlNode& node : nodes) {
    least = std::min(least, principal_sizes(node.size).l_t);
  }
  return least;
}

TEST(ControlNodes, HaveTheCornersOfTheDomain) {
  const auto wave = testing::paper_wave();
  expect_corners(wave->domain(), nodes_on(*wave, testing::paper_sizing()));
  expect_corners(wave->domain(), nodes_on(*wave, testing::paper_sizing(), {100, 0.1}));
}

TEST(ControlNodes, HaveTheCornersOfADomainThatRoundingWouldMove) {
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                               {0.1, 0.7, -1.0 / 3, 1e-3});
  expect_corners(plane.domain(), nodes_on(plane, sizing_of(0.25, 0.01, 0.1, 2)));
  expect_corners(plane.domain(), nodes_on(plane, sizing_of(0.25, 0.01, 0.1, 2), {49, 0.1}));
}

TEST(ControlNodes, HaveNoPositionTwice) {
  const auto nodes = nodes_on(*testing::paper_wave(), testing::paper_sizing());
  EXPECT_EQ(positions(nodes).size(), nodes.size());
}

TEST(ControlNodes, CarryTheExactFieldAtTheirPosition) {
  const auto wave = testing::paper_wave();
  const SizeField field(*wave, resolve(testing::paper_sizing(), 1), {});
  for (const ControlNode& node : choose_control_nodes(field, {0, 0.5}).nodes) {
    const SizeField::Sample sample = field.at(node.uv);
    ASSERT_EQ(node.size, sample.size);
    ASSERT_EQ(node.point, sample.point);
  }
}

TEST(ControlNodes, AreAsManyRegularOnesAsAskedFor) {
  const auto wave = testing::paper_wave();
  for (const int count : {4, 9, 400, 2500}) {
    EXPECT_EQ(static_cast<int>(nodes_on(*wave, testing::paper_sizing(), {count, 0.1}).size()),
              count);
  }
}

TEST(ControlNodes, AreTheNearestSquareOfRegularOnes) {
  const auto wave = testing::paper_wave();
  EXPECT_EQ(nodes_on(*wave, testing::paper_sizing(), {5, 0.1}).size(), 4U);
  EXPECT_EQ(nodes_on(*wave, testing::paper_sizing(), {8, 0.1}).size(), 9U);
}

TEST(ControlNodes, AreFewInAConstantField) {
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  EXPECT_LE(nodes_on(plane, sizing_of(0.25, 1e-4, 1e-3, 2)).size(), 25U);
}

TEST(ControlNodes, AreMoreForAFinerPrecision) {
  const auto wave = testing::paper_wave();
  std::size_t last = 0;
  for (const double precision : {0.4, 0.2, 0.1, 0.05}) {
    const std::size_t count = nodes_on(*wave, testing::paper_sizing(), {0, precision}).size();
    EXPECT_GT(count, last) << precision;
    last = count;
  }
}

TEST(ControlNodes, RepresentASmoothFieldToThePrecision) {
  // The outside of a torus, where no curvature is zero, has no kinks in its sizes.
  const test::Torus torus(3, 1, {0, 6, -1, 1});
  const SizeField field(torus, resolve(sizing_of(0.25, 1e-3, 100, 100), 1), {});
  for (const double precision : {0.2, 0.1, 0.05}) {
    const auto nodes = choose_control_nodes(field, {0, precision}).nodes;
    const ControlMesh control(torus.domain(), nodes, {});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    QueryHint hint;
    int good = 0;
    for (int i = 0; i < 2000; ++i) {
      const double s = uniform(random);
      const Uv uv = torus.domain().at(s, uniform(random));
      const SizeField::Sample exact = field.at(uv);
      const SizeTensor held = control.size({uv, exact.point, exact.form}, hint);
      if (log_conformity(exact.size, held) <= precision) ++good;
    }
    EXPECT_GE(good, 1900) << precision;
  }
}

TEST(ControlNodes, AreNotFooledByAFieldThatIsLargestAtAllOfThem) {
  const auto nodes = nodes_on(*testing::sine_wave(), sizing_of(0.25, 0.01, 1, 5));
  EXPECT_GT(nodes.size(), 100U);
  EXPECT_NEAR(least_size(nodes), 0.25 / 4, 0.01 * 0.25 / 4);
}

TEST(ControlNodes, EndAtASizeThatJumps) {
  const auto nodes = nodes_on(*testing::half_bent_sheet(), sizing_of(0.25, 0.01, 0.5, 5));
  EXPECT_GT(nodes.size(), 50U);
  EXPECT_LT(nodes.size(), 5000U);
}

TEST(ControlNodes, FollowASizeBelowTheResolutionOfNoCell) {
  // Elements much larger than the domain: the first cells are kept as they are.
  EXPECT_EQ(nodes_on(*testing::half_bent_sheet(), sizing_of(0, 100, 1000, 5)).size(), 25U);
}

/// Sizes of aspect 1,000 whose direction turns by 30 radians over the unit square along an axis.
SizeField turning_field(const Surface& plane, bool along_u) {
  PatchSources sources;
  sources.fields.push_back({.metric = [along_u](Uv uv, const Vec3&) {
    const double angle = 30 * (along_u ? uv.u : uv.v), c = std::cos(angle), s = std::sin(angle);
    const double fine = 1 / (3e-4 * 3e-4), coarse = 1 / (0.3 * 0.3);
    return Metric{fine * c * c + coarse * s * s, (fine - coarse) * c * s,
                  fine * s * s + coarse * c * c};
  }});
  return {plane, resolve(sizing_of(0, 1e-6, 1, 2), 1), sources};
}

TEST(ControlNodes, LieDenselyOnlyAlongTheDirectionInWhichTheFieldTurns) {
  // To hold it to the precision h takes steps of 0.02 radians: 1,500 lines of five nodes, and twice
  // as many halved ones.
  const test::PlanePatch plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  for (const bool along_u : {true, false}) {
    const ChosenNodes chosen = choose_control_nodes(turning_field(plane, along_u), {});
    EXPECT_FALSE(chosen.is_coarse) << along_u;
    EXPECT_LT(chosen.nodes.size(), 25'000u) << along_u;
  }
}

TEST(ControlNodes, AreNotHalvedAlongACreaseBesideIt) {
  // The curvature ends at u = 0, all along v: cells there become narrow, not short.
  const auto sheet = testing::half_bent_sheet();
  const auto nodes = nodes_on(*sheet, sizing_of(0.25, 0.01, 0.5, 5));
  std::set<double> heights;
  for (const ControlNode& node : nodes) heights.insert(node.uv.v);
  EXPECT_LE(heights.size(), 9u);
}

TEST(ControlNodes, AreTheSameAtAnyScaleOfTheParameters) {
  const auto wave = nodes_on(*testing::paper_wave(), testing::paper_sizing(), {0, 0.3});
  const auto scaled = nodes_on(*testing::paper_wave(1e6, 1e-3), testing::paper_sizing(), {0, 0.3});
  EXPECT_NEAR(static_cast<double>(scaled.size()), static_cast<double>(wave.size()),
              0.01 * static_cast<double>(wave.size()));
}

TEST(ControlNodes, TellHowFarTheirNeighboursAre) {
  for (const ControlNode& node : nodes_on(*testing::paper_wave(), testing::paper_sizing())) {
    ASSERT_GT(node.spacing.m11, 0);
    ASSERT_EQ(node.spacing.m12, 0);
    ASSERT_GT(node.spacing.m22, 0);
  }
}

TEST(ControlNodes, CoverTheWholeRectangleOfATriangle) {
  const test::Torus torus(3, 1, {0, 2, 0, 1, Domain::Shape::Triangle});
  expect_corners(torus.domain(), nodes_on(torus, sizing_of(0.25, 0.01, 1, 5)));
}

TEST(ControlNodeOptions, AreCheckedByName) {
  const auto error = [](const ControlNodeOptions& options) {
    return error_of([&] { check(options); });
  };
  for (const int bad : {-1, 1, 3}) {
    EXPECT_NE(error({bad, 0.1}).find("nodes"), std::string::npos) << bad;
  }
  for (const double bad : {0.0, -0.1, kUnset}) {
    EXPECT_NE(error({0, bad}).find("precision"), std::string::npos) << bad;
  }
  EXPECT_EQ(error({0, 0.1}), "no error");
  EXPECT_EQ(error({4, 0.1}), "no error");
}

TEST(ControlNodeOptions, AreCheckedBeforeNodesAreChosen) {
  const auto wave = testing::paper_wave();
  EXPECT_THROW(nodes_on(*wave, testing::paper_sizing(), {3, 0.1}), Error);
  EXPECT_THROW(nodes_on(*wave, testing::paper_sizing(), {0, 0}), Error);
}

}  // namespace
}  // namespace surfmesh
