// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/contour_nodes.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "support/errors.hh"
#include "support/models.hh"
#include "surfmesh/boundary/contour_memory.hh"
#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/geometry/crossing_segments.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::contour_index;
using testing::isotropic_field;
using testing::model_of;
using testing::UniformSizes;

/// Of two of MetricArc.
constexpr double kErrorOfTwoArcs = 2e-3;

constexpr SegmentParity kAnyOrEven[] = {SegmentParity::Any, SegmentParity::EvenContours};

BoundaryNodes place(const Model& model, double size, SegmentParity parity = SegmentParity::Any) {
  return place_contour_nodes(model, UniformSizes(model, size), {parity});
}

const Contour& contour(const Model& model, std::string_view name) {
  return model.contours[static_cast<std::size_t>(contour_index(model, name))];
}

const ContourNodes& nodes_of(const Model& model, const BoundaryNodes& nodes,
                             std::string_view name) {
  return nodes.contours[static_cast<std::size_t>(contour_index(model, name))];
}

int count(const Model& model, const BoundaryNodes& nodes, std::string_view name) {
  return nodes_of(model, nodes, name).segment_count();
}

/// The metric lengths of the segments of a contour, seen from one of its uses.
std::vector<double> lengths(const ContourNodes& nodes, std::size_t use, const MetricField& field) {
  std::vector<double> result;
  const std::vector<Uv>& uv = nodes.uv[use];
  for (std::size_t i = 0; i + 1 < uv.size(); ++i) {
    result.push_back(MetricArc(SegmentCurve(uv[i], uv[i + 1]), field).length());
  }
  return result;
}

/// Expect that every node lies at one place in space, whatever the use.
void expect_same_points(const Model& model, const BoundaryNodes& nodes) {
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    for (std::size_t use = 0; use < model.contours[c].uses.size(); ++use) {
      const int patch = model.contours[c].uses[use].patch;
      const Surface& surface = *model.patches[static_cast<std::size_t>(patch)].surface;
      for (std::size_t i = 0; i < nodes.contours[c].points.size(); ++i) {
        const Vec3 point = surface.evaluate(nodes.contours[c].uv[use][i], Order::Position).point;
        EXPECT_LT((point - nodes.contours[c].points[i]).norm(), 2e-9 * model.diagonal);
      }
    }
  }
}

TEST(ContourNodes, AreTheNearestIntegerToTheLength) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  EXPECT_EQ(count(model, place(model, 1 / 5.4), "p0:v0"), 5);
  EXPECT_EQ(count(model, place(model, 1 / 5.6), "p0:v0"), 6);
  EXPECT_EQ(count(model, place(model, 1 / 1.2), "p0:v0"), 1);
  EXPECT_EQ(count(model, place(model, 100), "p0:v0"), 1);
}

TEST(ContourNodes, LieAtEqualMetricDistances) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  const auto field = isotropic_field([](Uv uv) { return 0.02 + 0.1 * uv.u; });
  const BoundaryNodes nodes = place_contour_nodes(model, {&field});
  const auto all = lengths(nodes_of(model, nodes, "p0:v0"), 0, field);
  const auto [least, longest] = std::minmax_element(all.begin(), all.end());
  EXPECT_LT(*longest - *least, kErrorOfTwoArcs * static_cast<double>(all.size()));
}

TEST(ContourNodes, EndExactlyAtTheVertices) {
  const Model model = model_of({testing::rectangle(0.1, -1.0 / 3, 0.7, 1)});
  const BoundaryNodes nodes = place(model, 0.1);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const auto vertex = [&](int v) { return model.vertices[static_cast<std::size_t>(v)].position; };
    const Curve& curve = *model.contours[c].uses[0].curve;
    EXPECT_EQ(nodes.contours[c].points.front(), vertex(model.contours[c].start));
    EXPECT_EQ(nodes.contours[c].points.back(), vertex(model.contours[c].end));
    EXPECT_EQ(nodes.contours[c].uv[0].front(), curve.evaluate(0));
    EXPECT_EQ(nodes.contours[c].uv[0].back(), curve.evaluate(1));
  }
}

TEST(ContourNodes, AreThoseOfTheFinerPatch) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const auto coarse = isotropic_field(0.3), fine = isotropic_field(0.1);
  EXPECT_EQ(count(model, place_contour_nodes(model, {&coarse, &fine}), "p0:u1"), 10);
  EXPECT_EQ(count(model, place_contour_nodes(model, {&fine, &coarse}), "p0:u1"), 10);
  EXPECT_EQ(count(model, place_contour_nodes(model, {&fine, &coarse}), "p0:u0"), 10);
  EXPECT_EQ(count(model, place_contour_nodes(model, {&fine, &coarse}), "p1:u1"), 3);
}

TEST(ContourNodes, HaveNoSegmentLongerThanTheRootOfTwoInAnyPatch) {
  // Each patch is fine where the other is coarse.
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const auto below = isotropic_field([](Uv uv) { return 0.01 + 0.3 * uv.v; });
  const auto above = isotropic_field([](Uv uv) { return 0.012 + 0.3 * (1 - uv.v); });
  for (const SegmentParity parity : kAnyOrEven) {
    const BoundaryNodes nodes = place_contour_nodes(model, {&below, &above}, {parity});
    for (const double l : lengths(nodes_of(model, nodes, "p0:u1"), 0, below)) {
      EXPECT_LE(l, std::numbers::sqrt2 * (1 + kErrorOfTwoArcs));
    }
    for (const double l : lengths(nodes_of(model, nodes, "p0:u1"), 1, above)) {
      EXPECT_LE(l, std::numbers::sqrt2 * (1 + kErrorOfTwoArcs));
    }
  }
}

TEST(ContourNodes, AreNotManyMoreThanTheFinestPatchWantsAtEachPlace) {
  // The segments of the first patch are a little too long for the second one on most of the side.
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const auto first = isotropic_field([](Uv uv) { return uv.v < 0.8 ? 0.01 : 0.01 / 1.8; });
  const auto second = isotropic_field([](Uv uv) { return uv.v < 0.8 ? 0.01 / 1.43 : 1.0; });
  const double wanted = 100 * (0.8 * 1.43 + 0.2 * 1.8);
  for (const SegmentParity parity : kAnyOrEven) {
    const BoundaryNodes nodes = place_contour_nodes(model, {&first, &second}, {parity});
    EXPECT_LE(count(model, nodes, "p0:u1"), 1.25 * wanted + 1);
    for (const double l : lengths(nodes_of(model, nodes, "p0:u1"), 1, second)) {
      EXPECT_LE(l, std::numbers::sqrt2 * (1 + kErrorOfTwoArcs));
    }
  }
}

TEST(ContourNodes, MakeLoopsThatDoNotCrossWhereTheirCurvesDoNot) {
  for (const double gap : {0.1, 0.01, 1e-3, 1e-5}) {
    const Model model = testing::narrow_ring(1 - gap);
    for (const SegmentParity parity : kAnyOrEven) {
      const BoundaryNodes nodes = place(model, 1.2, parity);
      const auto& outer = nodes_of(model, nodes, "outer").uv[0];
      const auto& inner = nodes_of(model, nodes, "hole").uv[0];
      EXPECT_TRUE(parity == SegmentParity::Any || (outer.size() - 1) % 2 == 0);
      EXPECT_TRUE(detail::crossing_segments(
                      {{outer.begin(), outer.end() - 1}, {inner.begin(), inner.end() - 1}})
                      .empty())
          << gap;
      EXPECT_LT(static_cast<double>(outer.size()), 6 + 20 / std::sqrt(gap));
    }
  }
}

TEST(ContourNodes, HaveNoLongSegmentWhereTheirNumberIsRoundedDown) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  for (const double length : {1.45, 2.9, 5.8}) {
    for (const SegmentParity parity : kAnyOrEven) {
      const UniformSizes field(model, 1 / length);
      const BoundaryNodes nodes = place_contour_nodes(model, field, {parity});
      for (const double l : lengths(nodes_of(model, nodes, "p0:v0"), 0, field[0])) {
        EXPECT_LE(l, std::numbers::sqrt2) << length;
      }
    }
  }
}

TEST(ContourNodes, AreEvenOnEachContour) {
  const std::vector<Model> models = {
      model_of({testing::rectangle(0, 0, 1, 0.7), testing::rectangle(1, 0, 2, 0.7)}),
      model_of({testing::sphere()}), model_of({testing::whole_torus()})};
  for (const Model& model : models) {
    for (const double size : {0.013, 0.1, 0.33, 100.0}) {
      const BoundaryNodes nodes = place(model, size, SegmentParity::EvenContours);
      for (std::size_t c = 0; c < model.contours.size(); ++c) {
        if (model.contours[c].is_degenerate) continue;
        EXPECT_EQ(nodes.contours[c].segment_count() % 2, 0) << model.contours[c].name;
      }
    }
  }
}

TEST(ContourNodes, MakeAtLeastATriangleOfAClosedContour) {
  const Model torus = model_of({testing::whole_torus()});
  const BoundaryNodes nodes = place(torus, 100);
  for (const ContourNodes& list : nodes.contours) EXPECT_EQ(list.segment_count(), 3);
  const Model hole = testing::square_with_hole(0.1);
  EXPECT_EQ(count(hole, place(hole, 100), "hole"), 3);
}

TEST(ContourNodes, TellContoursBetweenTheSameVerticesApart) {
  const Model model = model_of({testing::cylinder(0, pi), testing::cylinder(pi, 2 * pi)});
  const BoundaryNodes nodes = place(model, 100);
  EXPECT_EQ(count(model, nodes, "p0:v0"), 2);
  EXPECT_EQ(count(model, nodes, "p1:v0"), 2);
  EXPECT_EQ(count(model, nodes, "p0:u0"), 1);
}

TEST(ContourNodes, LeaveOneToSpareBesideEachPole) {
  const Model whole = model_of({testing::sphere()});
  EXPECT_EQ(count(whole, place(whole, 100), "p0:u1"), 3);
  const auto cap = std::make_shared<test::Sphere>(1, Domain{0, 2 * pi, 0, pi / 2});
  const Model half = model_of({cap});
  EXPECT_EQ(count(half, place(half, 100), "p0:u1"), 2);
}

TEST(ContourNodes, OfAPoleAreOneSegmentOfNoLength) {
  const Model model = model_of({testing::sphere()});
  const BoundaryNodes nodes = place(model, 0.1);
  const ContourNodes& pole = nodes_of(model, nodes, "p0:v1");
  ASSERT_EQ(pole.segment_count(), 1);
  EXPECT_LT((pole.points[0] - Vec3(0, 0, 1)).norm(), 1e-15);
  EXPECT_EQ(pole.points[0], pole.points[1]);
  EXPECT_NEAR(std::abs(pole.uv[0][1].u - pole.uv[0][0].u), 2 * pi, 1e-14);
}

TEST(ContourNodes, AreTheSamePointsOnAllUses) {
  const Model model = model_of({testing::sphere(0, 2), testing::sphere(2, 2 * pi)});
  expect_same_points(model, place(model, 0.1));
}

TEST(ContourNodes, AreTheSamePointsAtDifferentSpeeds) {
  const auto fast = std::make_shared<test::Reparametrised>(testing::rectangle(0, 1, 1, 2));
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), fast});
  ASSERT_FALSE(contour(model, "p0:v1").uses[1].is_same_speed);
  const auto coarse = isotropic_field(0.3), fine = isotropic_field(0.01);
  for (const auto& fields : {std::array<const MetricField*, 2>{&coarse, &fine},
                             std::array<const MetricField*, 2>{&fine, &coarse}}) {
    const BoundaryNodes nodes = place_contour_nodes(model, {fields[0], fields[1]});
    EXPECT_GT(count(model, nodes, "p0:v1"), 90);
    expect_same_points(model, nodes);
  }
}

TEST(ContourNodes, RunOneWayOnAllUses) {
  const auto fast = std::make_shared<test::Reparametrised>(testing::rectangle(0, 1, 1, 2));
  const Model model = model_of({testing::rectangle(0, 0, 1, 1), fast});
  const BoundaryNodes nodes = place(model, 0.01);
  for (const auto& uv : nodes_of(model, nodes, "p0:v1").uv) {
    for (std::size_t i = 0; i + 1 < uv.size(); ++i) EXPECT_LT(uv[i].u, uv[i + 1].u);
  }
}

TEST(ContourNodes, LieOnASeamOnBothOfItsSides) {
  const Model model = model_of({testing::whole_torus()});
  const BoundaryNodes nodes = place(model, 0.2);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    ASSERT_EQ(nodes.contours[c].uv.size(), 2U);
    EXPECT_EQ(nodes.contours[c].uv[0].size(), nodes.contours[c].uv[1].size());
  }
  expect_same_points(model, nodes);
}

TEST(ContourNodes, OfAContourWithoutUsesAreNone) {
  Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  Contour unused;
  unused.start = 0;
  unused.end = 1;
  model.contours.push_back(unused);
  EXPECT_TRUE(place(model, 0.1).contours.back().points.empty());
}

TEST(ContourNodes, AreTheSameEveryTime) {
  const Model model = model_of({testing::sphere(0, 2), testing::sphere(2, 2 * pi)});
  const BoundaryNodes a = place(model, 0.07, SegmentParity::EvenContours),
                      b = place(model, 0.07, SegmentParity::EvenContours);
  ASSERT_EQ(a.contours.size(), b.contours.size());
  for (std::size_t c = 0; c < a.contours.size(); ++c) {
    EXPECT_EQ(a.contours[c].points, b.contours[c].points);
    EXPECT_EQ(a.contours[c].uv, b.contours[c].uv);
  }
}

TEST(ContourNodes, TellTheQueriesTheyCost) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  const std::size_t queries = place(model, 0.01).report.queries.total();
  EXPECT_GE(queries, 400U);
  EXPECT_LE(queries, 8 * 400U);
}

TEST(ContourNodes, AreAsManyAsTheSagTakes) {
  const Model model = testing::square_with_hole(0.5);
  for (const double sag : {0.05, 0.005, 0.001}) {
    const auto nodes = place_contour_nodes(model, UniformSizes(model, 0.2), {.sag = sag});
    const ContourNodes& hole = nodes_of(model, nodes, "hole");
    double greatest = 0;
    for (std::size_t i = 0; i + 1 < hole.points.size(); ++i) {
      greatest = std::max(greatest, 0.5 - (0.5 * (hole.points[i] + hole.points[i + 1])).norm());
    }
    EXPECT_LE(greatest, sag);
    EXPECT_GE(hole.segment_count(), 11) << "at √½ of the metric length";
  }
}

/// Two squares side by side, whose contours are divided again and again with the same memory.
class ContourMemoryTest : public ::testing::Test {
 protected:
  BoundaryNodes place(double size, std::vector<double> more_segments = {}) {
    return place_contour_nodes(model_, UniformSizes(model_, size),
                               {.sag = 0.1, .more_segments = std::move(more_segments)}, context_,
                               &memory_);
  }

  static std::size_t queries(const BoundaryNodes& nodes) { return nodes.report.queries.total(); }

  Model model_ = model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  RunContext context_;
  ContourMemory memory_;
};

TEST_F(ContourMemoryTest, SparesContoursThatAreAsTheyWere) {
  const BoundaryNodes first = place(0.1);
  ASSERT_GT(queries(first), 0u);
  const BoundaryNodes again = place(0.1);
  EXPECT_EQ(queries(again), 0u);
  for (std::size_t c = 0; c < model_.contours.size(); ++c) {
    EXPECT_EQ(again.contours[c].uv, first.contours[c].uv);
  }
}

TEST_F(ContourMemoryTest, ForgetsContoursBesidePatchesThatHaveChanged) {
  const BoundaryNodes first = place(0.1);
  memory_.forget_changed(model_, {0, 1});
  const BoundaryNodes second = place(0.05);
  EXPECT_EQ(count(model_, second, "p0:u0"), count(model_, first, "p0:u0"));
  EXPECT_GT(count(model_, second, "p1:u1"), count(model_, first, "p1:u1"));
  EXPECT_GT(count(model_, second, "p0:u1"), count(model_, first, "p0:u1"));  // between both
}

TEST_F(ContourMemoryTest, DividesContoursOfAnotherFactorAnew) {
  const BoundaryNodes first = place(0.1);
  std::vector<double> more(model_.contours.size(), 1);
  more[static_cast<std::size_t>(contour_index(model_, "p0:u0"))] = 2;
  const BoundaryNodes second = place(0.1, more);
  EXPECT_GT(count(model_, second, "p0:u0"), count(model_, first, "p0:u0"));
  EXPECT_EQ(count(model_, second, "p1:u1"), count(model_, first, "p1:u1"));
  EXPECT_LT(queries(second), queries(first));
}

TEST(ContourNodes, RefuseASagThatIsNone) {
  const Model model = testing::unit_square();
  EXPECT_NE(error_of([&] {
              place_contour_nodes(model, UniformSizes(model, 1), {.sag = 0.0});
            }).find("a sag of 0 "),
            std::string::npos);
}

}  // namespace
}  // namespace surfmesh
