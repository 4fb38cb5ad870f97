// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/patch_geometry.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quad/grid_patch.hh"

namespace surfmesh {
namespace {

using testing::GridPatch;

/// A metric that changes and turns.
testing::FunctionField changing_field() {
  return testing::FunctionField([](Uv p) {
    const double angle = 0.3 + 0.2 * p.u - 0.1 * p.v;
    return testing::directed_metric({std::cos(angle), std::sin(angle)}, 1 + 0.1 * p.u,
                                    0.7 + 0.1 * p.v);
  });
}

/// The sides of the corner at the tip of a halfedge, measured by hand.
CornerMeasure corner_at_tip(const GridPatch& patch, HalfedgeHandle heh) {
  const VertexHandle vh = patch.mesh.to_vertex_handle(heh);
  const Metric& m = patch.metric(vh);
  const Uv at = patch.uv(vh);
  const Uv next = patch.uv(patch.mesh.to_vertex_handle(patch.mesh.next_halfedge_handle(heh))) - at;
  const Uv previous = patch.uv(patch.mesh.from_vertex_handle(heh)) - at;
  return {squared_length(m, next) + squared_length(m, previous),
          std::sqrt(determinant(m)) * cross(next, previous)};
}

/// The three corners of each face around a vertex that depend on it: its own, and both beside it.
std::vector<CornerMeasure> corners_around(const GridPatch& patch, VertexHandle vh) {
  std::vector<CornerMeasure> corners;
  const HalfedgeHandle start = patch.mesh.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  do {
    const HalfedgeHandle into = patch.mesh.prev_halfedge_handle(heh);
    corners.push_back(corner_at_tip(patch, into));
    corners.push_back(corner_at_tip(patch, heh));
    corners.push_back(corner_at_tip(patch, patch.mesh.prev_halfedge_handle(into)));
    heh = patch.mesh.opposite_halfedge_handle(into);
  } while (heh != start);
  return corners;
}

TEST(PatchGeometry, MeasuresARectangleAsOne) {
  const GridPatch patch(1, 1, testing::constant_field({4, 0, 0.25}));
  EXPECT_NEAR(patch.geometry.measure(FaceHandle(0)).least_jacobian, 1, 1e-15);
}

TEST(PatchGeometry, MeasuresARhombusAsTheSineOfItsAngle) {
  for (const double angle : {0.2, 0.7, 1.2, 2.0}) {
    const double c = std::cos(angle);
    const GridPatch patch(1, 1, testing::constant_field({1, c, 1}));  // unit sides at that angle
    EXPECT_NEAR(patch.geometry.measure(FaceHandle(0)).least_jacobian, std::sin(angle), 1e-14);
  }
}

TEST(PatchGeometry, MeasuresTheEnergyOfAllCorners) {
  const GridPatch square(1, 1), changing(2, 2, changing_field());
  EXPECT_DOUBLE_EQ(square.geometry.measure(FaceHandle(0)).energy, 4 * corner_energy({2, 1}, {}));
  double energy = 0;
  for (const HalfedgeHandle heh : changing.mesh.fh_range(changing.face(1, 0))) {
    energy += corner_energy(corner_at_tip(changing, heh), {});
  }
  EXPECT_NEAR(changing.geometry.measure(changing.face(1, 0)).energy, energy, 1e-12);
}

TEST(PatchGeometry, MeasuresAnInvertedQuadAsNegative) {
  GridPatch patch(2, 2);
  patch.put(patch.vertex(1, 1), {-0.5, -0.5});
  EXPECT_LT(patch.geometry.measure(patch.face(0, 0)).least_jacobian, 0);
}

TEST(PatchGeometry, MeasuresASideOfNoLengthAsZero) {
  GridPatch patch(2, 2);
  patch.put(patch.vertex(1, 1), {1, 0});
  EXPECT_EQ(patch.geometry.measure(patch.face(0, 0)).least_jacobian, 0);
}

TEST(PatchGeometry, FixesTheBoundaryOnly) {
  const GridPatch patch(3, 3);
  EXPECT_FALSE(patch.geometry.is_free(patch.vertex(1, 0)));
  EXPECT_FALSE(patch.geometry.is_free(patch.vertex(0, 2)));
  EXPECT_TRUE(patch.geometry.is_free(patch.vertex(1, 1)));
  EXPECT_TRUE(patch.geometry.is_free(patch.vertex(2, 2)));
}

TEST(PatchGeometry, CollectsTheCornersAroundAVertex) {
  const GridPatch patch(3, 3, changing_field());
  std::vector<CornerTerms> star;
  ASSERT_TRUE(patch.geometry.collect(patch.vertex(1, 1), star));
  const auto corners = corners_around(patch, patch.vertex(1, 1));
  ASSERT_EQ(star.size(), corners.size());
  for (std::size_t k = 0; k < star.size(); ++k) {
    EXPECT_NEAR(star[k].at.s, corners[k].s, 1e-13);
    EXPECT_NEAR(star[k].at.d, corners[k].d, 1e-13);
  }
}

/// In a constant metric the terms are exact, however far the step.
TEST(PatchGeometry, TellsHowCornersChangeByAStep) {
  const Metric metric = testing::directed_metric({0.6, 0.8}, 1.5, 0.5);
  for (const ChartStep step : {ChartStep{0.3, 0}, ChartStep{0, -0.4}, ChartStep{-0.2, 0.35}}) {
    GridPatch patch(3, 3, testing::constant_field(metric));
    const VertexHandle vh = patch.vertex(1, 1);
    std::vector<CornerTerms> star;
    ASSERT_TRUE(patch.geometry.collect(vh, star));
    ASSERT_TRUE(patch.geometry.move(vh, step));
    const auto corners = corners_around(patch, vh);
    for (std::size_t k = 0; k < star.size(); ++k) {
      EXPECT_NEAR(star[k].after(step).s, corners[k].s, 1e-12);
      EXPECT_NEAR(star[k].after(step).d, corners[k].d, 1e-12);
    }
  }
}

TEST(PatchGeometry, CollectsNothingWhereTheMetricIsSingular) {
  GridPatch patch(2, 2);
  const auto metric = require(patch.mesh, keys::vertex_metric);
  patch.mesh.property(metric, patch.vertex(1, 1)) = {0, 0, 1};
  std::vector<CornerTerms> star;
  EXPECT_FALSE(patch.geometry.collect(patch.vertex(1, 1), star));
}

TEST(PatchGeometry, MovesByTheMetricLengthOfTheStepAndAsksForTheMetricThere) {
  GridPatch patch(3, 3, changing_field());
  const VertexHandle vh = patch.vertex(1, 1);
  const Metric before = patch.metric(vh);
  ASSERT_TRUE(patch.geometry.move(vh, {0.03, 0.04}));
  EXPECT_NEAR(squared_length(before, patch.uv(vh) - Uv{1, 1}), 0.0025, 1e-15);
  EXPECT_EQ(patch.metric(vh), patch.field(patch.uv(vh)));
  EXPECT_EQ(patch.geometry.queries().total(), 1u);
}

TEST(PatchGeometry, RefusesAMoveOutOfTheBoundsOfTheBoundary) {
  GridPatch patch(2, 2);
  const VertexHandle vh = patch.vertex(1, 1);
  EXPECT_FALSE(patch.geometry.move(vh, {1.1, 0}));
  EXPECT_FALSE(patch.geometry.move(vh, {0, -1.1}));
  EXPECT_EQ(patch.uv(vh), (Uv{1, 1}));
  EXPECT_EQ(patch.geometry.queries().total(), 0u);
  EXPECT_TRUE(patch.geometry.move(vh, {0.9, 0}));
}

TEST(PatchGeometry, PutsAVertexInTheMiddleOfOthers) {
  GridPatch patch(2, 2);
  const VertexHandle vh = patch.editor.add_vertex();
  patch.geometry.put_between(vh, std::vector{patch.vertex(0, 0), patch.vertex(0, 0),
                                             patch.vertex(2, 0), patch.vertex(2, 2)});
  EXPECT_EQ(patch.uv(vh), (Uv{1, 0.5}));
}

TEST(PatchGeometry, IsAsBeforeWhenATrialIsUndone) {
  GridPatch patch(3, 3, changing_field());
  const VertexHandle a = patch.vertex(1, 1), b = patch.vertex(2, 1);
  const Metric metric = patch.metric(a);
  const FaceMeasure measure = patch.geometry.measure(patch.face(1, 1));
  patch.geometry.begin_trial();
  ASSERT_TRUE(patch.geometry.move(a, {0.1, 0.1}));
  ASSERT_TRUE(patch.geometry.move(b, {0.1, -0.1}));
  ASSERT_TRUE(patch.geometry.move(a, {-0.3, 0.1}));
  EXPECT_NE(patch.geometry.measure(patch.face(1, 1)).energy, measure.energy);
  patch.geometry.undo_trial();
  EXPECT_EQ(patch.uv(a), (Uv{1, 1}));
  EXPECT_EQ(patch.uv(b), (Uv{2, 1}));
  EXPECT_EQ(patch.metric(a), metric);
  EXPECT_EQ(patch.geometry.measure(patch.face(1, 1)).energy, measure.energy);
}

TEST(PatchGeometry, DoesNotUndoWhatATrialBeforeHasKept) {
  GridPatch patch(3, 3);
  const VertexHandle vh = patch.vertex(1, 1);
  patch.geometry.begin_trial();
  ASSERT_TRUE(patch.geometry.move(vh, {0.25, 0}));
  patch.geometry.keep_trial();
  ASSERT_TRUE(patch.geometry.move(vh, {0.25, 0}));  // in no trial
  patch.geometry.begin_trial();
  ASSERT_TRUE(patch.geometry.move(vh, {0.25, 0}));
  patch.geometry.undo_trial();
  EXPECT_EQ(patch.uv(vh), (Uv{1.5, 1}));
}

}  // namespace
}  // namespace surfmesh
