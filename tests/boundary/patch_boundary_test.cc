// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/patch_boundary.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "support/models.hh"
#include "surfmesh/boundary/metric_arc.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::model_of;
using testing::UniformSizes;

/// The boundaries of all patches of a model.
struct Boundaries {
  std::vector<ContourNodes> nodes;
  std::vector<PatchBoundary> patches;
  int vertex_count = 0;
};

Boundaries collect(const Model& model, double size) {
  const UniformSizes fields(model, size);
  Boundaries result{place_contour_nodes(model, fields).contours, {}, 0};
  const NodeNumbers numbers(model, result.nodes);
  result.vertex_count = numbers.count();
  for (int p = 0; p < static_cast<int>(model.patches.size()); ++p) {
    result.patches.push_back(collect_boundary(model, p, result.nodes, numbers, fields[p]));
  }
  return result;
}

double signed_area(const BoundaryLoop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    area += 0.5 * cross(loop[i].uv, loop[(i + 1) % loop.size()].uv);
  }
  return area;
}

/// The nodes of all loops, as the rings of fans count them.
std::vector<BoundaryNode> all_nodes(const PatchBoundary& boundary) {
  std::vector<BoundaryNode> nodes;
  for (const BoundaryLoop& loop : boundary.loops) {
    nodes.insert(nodes.end(), loop.begin(), loop.end());
  }
  return nodes;
}

/// Expect that equal numbers are equal points, all different numbers different ones.
void expect_numbers_are_points(const Model& model, const Boundaries& boundaries) {
  std::map<int, Vec3> points;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    for (const BoundaryNode& node : all_nodes(boundaries.patches[p])) {
      if (node.vertex < 0) continue;
      EXPECT_LT(node.vertex, boundaries.vertex_count);
      const Vec3 point = model.patches[p].surface->evaluate(node.uv, Order::Position).point;
      const auto [entry, is_new] = points.try_emplace(node.vertex, point);
      EXPECT_LT((entry->second - point).norm(), 2e-9 * model.diagonal) << node.vertex;
    }
  }
  for (auto a = points.begin(); a != points.end(); ++a) {
    for (auto b = std::next(a); b != points.end(); ++b) {
      EXPECT_GT((a->second - b->second).norm(), 1e-6 * model.diagonal);
    }
  }
}

TEST(PatchBoundary, RunsCounterClockwiseAroundTheDomain) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 0.7)});
  const Boundaries boundaries = collect(model, 0.1);
  ASSERT_EQ(boundaries.patches[0].loops.size(), 1U);
  EXPECT_EQ(boundaries.patches[0].loops[0].size(), 34U);
  EXPECT_NEAR(signed_area(boundaries.patches[0].loops[0]), 0.7, 1e-12);
}

TEST(PatchBoundary, IsClosedBySteps) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 0.7)});
  const Boundaries boundaries = collect(model, 0.1);
  const BoundaryLoop& loop = boundaries.patches[0].loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Uv step = loop[(i + 1) % loop.size()].uv - loop[i].uv;
    EXPECT_NEAR(std::hypot(step.u, step.v), 0.1, 1e-9);
  }
}

TEST(PatchBoundary, TellsTheContourOfEachSegment) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 0.7)});
  const Boundaries boundaries = collect(model, 0.1);
  const BoundaryLoop& loop = boundaries.patches[0].loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Uv middle = lerp(loop[i].uv, loop[(i + 1) % loop.size()].uv, 0.5);
    const std::string side = middle.v == 0   ? "p0:v0"
                             : middle.u == 1 ? "p0:u1"
                             : middle.u == 0 ? "p0:u0"
                                             : "p0:v1";
    EXPECT_EQ(model.contours[static_cast<std::size_t>(loop[i].contour)].name, side);
  }
}

TEST(PatchBoundary, SharesItsNumbersWithItsNeighbours) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const Boundaries boundaries = collect(model, 0.1);
  std::array<std::set<int>, 2> numbers;
  for (std::size_t p = 0; p < 2; ++p) {
    for (const BoundaryNode& node : boundaries.patches[p].loops[0]) numbers[p].insert(node.vertex);
  }
  std::vector<int> shared;
  std::set_intersection(numbers[0].begin(), numbers[0].end(), numbers[1].begin(), numbers[1].end(),
                        std::back_inserter(shared));
  EXPECT_EQ(shared.size(), 11U);
  expect_numbers_are_points(model, boundaries);
}

TEST(PatchBoundary, ShowsASeamOnBothSides) {
  const Model model = model_of({testing::whole_torus()});
  const Boundaries boundaries = collect(model, 0.3);
  const BoundaryLoop& loop = boundaries.patches[0].loops[0];
  EXPECT_NEAR(signed_area(loop), 4 * pi * pi, 1e-9);
  std::map<int, int> times;
  for (const BoundaryNode& node : loop) ++times[node.vertex];
  for (const auto& [vertex, count] : times) {
    EXPECT_TRUE(count == 2 || (count == 4 && vertex == 0)) << vertex;
  }
  EXPECT_EQ(static_cast<int>(times.size()), boundaries.vertex_count);
  expect_numbers_are_points(model, boundaries);
}

TEST(PatchBoundary, RunsClockwiseAroundAHole) {
  const Model model = testing::square_with_hole(0.4);
  const Boundaries boundaries = collect(model, 0.05);
  ASSERT_EQ(boundaries.patches[0].loops.size(), 2U);
  EXPECT_NEAR(signed_area(boundaries.patches[0].loops[0]), 4, 1e-12);
  EXPECT_NEAR(signed_area(boundaries.patches[0].loops[1]), -pi * 0.16, 0.01);
  expect_numbers_are_points(model, boundaries);
}

TEST(PatchBoundary, HasFansOnlyAtPoles) {
  for (const Model& model : {model_of({testing::whole_torus()}), testing::square_with_hole(0.4),
                             model_of({testing::cylinder(0, 2 * pi)})}) {
    EXPECT_TRUE(collect(model, 0.2).patches[0].fans.empty());
  }
}

// --- poles ---

/// Expect a fan whose ring is a chain of the loop, of the metric length of the ring.
void expect_ring(const PatchBoundary& boundary, const PoleFan& fan, const MetricField& field) {
  const std::vector<BoundaryNode> nodes = all_nodes(boundary);
  double length = 0;
  for (std::size_t i = 0; i + 1 < fan.ring.size(); ++i) {
    const BoundaryNode& a = nodes[static_cast<std::size_t>(fan.ring[i])];
    const BoundaryNode& b = nodes[static_cast<std::size_t>(fan.ring[i + 1])];
    EXPECT_EQ(a.contour, -1);
    EXPECT_EQ((fan.ring[i] + 1) % static_cast<int>(nodes.size()), fan.ring[i + 1]);
    if (i > 0) {
      EXPECT_EQ(a.vertex, -1);
    }
    length += MetricArc(SegmentCurve(a.uv, b.uv), field).length();
  }
  const int count = static_cast<int>(fan.ring.size()) - 1;
  EXPECT_EQ(count, std::max(3, static_cast<int>(std::lround(length))));
}

TEST(PoleFan, CutsBothPolesOffASphereOfOnePatch) {
  const Model model = model_of({testing::sphere()});
  for (const double size : {0.05, 0.3, 1.0, 100.0}) {
    const UniformSizes fields(model, size);
    const Boundaries boundaries = collect(model, size);
    const PatchBoundary& boundary = boundaries.patches[0];
    ASSERT_EQ(boundary.fans.size(), 2U);
    EXPECT_NE(boundary.fans[0].pole, boundary.fans[1].pole);
    for (const PoleFan& fan : boundary.fans) expect_ring(boundary, fan, fields[0]);
    EXPECT_GT(signed_area(boundary.loops[0]), 0);
    expect_numbers_are_points(model, boundaries);
  }
}

TEST(PoleFan, LeavesNoNodeOnThePole) {
  const Model model = model_of({testing::sphere()});
  const Boundaries boundaries = collect(model, 0.2);
  for (const BoundaryNode& node : boundaries.patches[0].loops[0]) {
    EXPECT_LT(std::abs(node.uv.v), pi / 2 - 0.05);
    for (const PoleFan& fan : boundaries.patches[0].fans) EXPECT_NE(node.vertex, fan.pole);
  }
}

TEST(PoleFan, HasAboutSixTrianglesWhateverTheSize) {
  const Model model = model_of({testing::sphere()});
  for (const double size : {0.01, 0.1, 0.3}) {
    const Boundaries boundaries = collect(model, size);
    for (const PoleFan& fan : boundaries.patches[0].fans) {
      EXPECT_NEAR(static_cast<double>(fan.ring.size()) - 1, 6, 1) << size;
    }
  }
}

TEST(PoleFan, IsSharedOutBetweenThePatchesAtAPole) {
  const Model model = model_of({testing::sphere(0, 2), testing::sphere(2, 2 * pi)});
  const Boundaries boundaries = collect(model, 0.1);
  for (const PatchBoundary& boundary : boundaries.patches) {
    ASSERT_EQ(boundary.fans.size(), 2U);
    for (const PoleFan& fan : boundary.fans) EXPECT_GE(fan.ring.size(), 3U);
  }
  expect_numbers_are_points(model, boundaries);
}

TEST(PoleFan, NeverJoinsTheSameNodesAsTheOneOfAnotherPatch) {
  // Elements larger than the sphere: each half's ring would be one segment, the same for both.
  const Model model = model_of({testing::sphere(0, pi), testing::sphere(pi, 2 * pi)});
  const Boundaries boundaries = collect(model, 100);
  int segments = 0;
  for (const PatchBoundary& boundary : boundaries.patches) {
    segments += static_cast<int>(boundary.fans[0].ring.size()) - 1;
  }
  EXPECT_GE(segments, 3);
}

TEST(PoleFan, CountsItsRingAmongTheNodesOfAllLoops) {
  const auto cap = std::make_shared<test::Sphere>(1, Domain{0, 2 * pi, 0, pi / 2});
  const Model model = model_of({cap});
  const UniformSizes fields(model, 0.2);
  const Boundaries boundaries = collect(model, 0.2);
  ASSERT_EQ(boundaries.patches[0].fans.size(), 1U);
  expect_ring(boundaries.patches[0], boundaries.patches[0].fans[0], fields[0]);
}

// --- numbers ---

TEST(NodeNumbers, AreAllDifferentAndInARow) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const auto nodes = place_contour_nodes(model, UniformSizes(model, 0.1)).contours;
  const NodeNumbers numbers(model, nodes);
  std::set<int> all;
  for (std::size_t v = 0; v < model.vertices.size(); ++v) all.insert(static_cast<int>(v));
  for (int c = 0; c < static_cast<int>(nodes.size()); ++c) {
    for (int i = 1; i < nodes[static_cast<std::size_t>(c)].segment_count(); ++i) {
      EXPECT_TRUE(all.insert(numbers(c, i)).second);
    }
  }
  EXPECT_EQ(static_cast<int>(all.size()), numbers.count());
  EXPECT_EQ(*all.rbegin(), numbers.count() - 1);
}

TEST(NodeNumbers, OfEndsAreTheVerticesOfTheModel) {
  const Model model = model_of({testing::sphere()});
  const auto nodes = place_contour_nodes(model, UniformSizes(model, 0.3)).contours;
  const NodeNumbers numbers(model, nodes);
  for (int c = 0; c < static_cast<int>(nodes.size()); ++c) {
    const Contour& contour = model.contours[static_cast<std::size_t>(c)];
    EXPECT_EQ(numbers(c, 0), contour.start);
    EXPECT_EQ(numbers(c, nodes[static_cast<std::size_t>(c)].segment_count()), contour.end);
  }
}

TEST(NodeNumbers, OfAContourWithoutNodesAreNone) {
  Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  model.contours.emplace_back();
  std::vector<ContourNodes> nodes(5);
  EXPECT_EQ(NodeNumbers(model, nodes).count(), 4);
}

}  // namespace
}  // namespace surfmesh
