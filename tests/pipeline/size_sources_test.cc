// SPDX-License-Identifier: BSD-3-Clause
// Lengths of the edges of the final mesh near the places of sources, on flat patches and on cages.
#include "cage/cages.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include "surfmesh/pipeline/mesh_model.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/sizes/tables_from_mesh.hh"

namespace surfmesh {
namespace {

using testing::size_of;
using testing::units;
using Where = std::function<bool(const Vec3&)>;

/// Sizes of 0.2 at most, nothing from the shape.
PipelineOptions coarse() {
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmin = units(1e-3), .hmax = units(0.2)};
  options.sizing.proximity = 0;
  options.sizing.features = false;
  return options;
}

/// Mean length of the edges with their middle at a place.
double mean_length(const PolyMesh& mesh, const Where& is_there) {
  double sum = 0;
  int count = 0;
  for (const auto edge : mesh.edges()) {
    const Vec3 a = to_eigen(mesh.point(edge.v0())), b = to_eigen(mesh.point(edge.v1()));
    if (!is_there(0.5 * (a + b))) continue;
    sum += (a - b).norm();
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

Where within(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() < radius; };
}

/// A square, or one face of a cage without curvature, as the model's first patch.
class SizesOn : public ::testing::TestWithParam<std::string> {
 protected:
  Model model() const {
    if (GetParam() == "square") return testing::unit_square();
    return model_from_cage(testing::sheet(1, 1), {.scheme = Scheme::Bilinear});
  }

  Vec3 at(Uv uv) const { return model_.patches[0].surface->evaluate(uv, Order::Position).point; }

  double mean_near(const Sources& sources, Uv uv, double radius) const {
    return mean_length(mesh_model(model_, sources, coarse()).mesh, within(at(uv), radius));
  }

  Model model_ = model();
};

constexpr double kTolerance = 0.15;

TEST_P(SizesOn, HoldAroundAPoint) {
  Sources sources;
  sources.everywhere.push_back({0, size_of(0.2)});
  sources.at.push_back({0, {0.4, 0.4}, size_of(0.02), units(0.15)});
  EXPECT_NEAR(mean_near(sources, {0.4, 0.4}, 0.12), 0.02, kTolerance * 0.02);
}

TEST_P(SizesOn, GoOverToTheOuterOne) {
  Sources sources;
  sources.everywhere.push_back({0, size_of(0.2)});
  sources.at.push_back(
      {0, {0.5, 0.5}, size_of(0.02), units(0.1), Outer{size_of(0.06), units(0.15)}});
  EXPECT_NEAR(mean_near(sources, {0.5, 0.5}, 0.08), 0.02, kTolerance * 0.02);
  // From 0.25 on; within it sizes change by less than the grade allows.
  const Where ring = [this](const Vec3& p) {
    return std::abs((p - at({0.5, 0.5})).norm() - 0.26) < 0.02;
  };
  EXPECT_NEAR(mean_length(mesh_model(model_, sources, coarse()).mesh, ring), 0.06, 0.25 * 0.06);
}

TEST_P(SizesOn, HoldAlongACurve) {
  Sources sources;
  sources.along.push_back({0,
                           {std::make_shared<SegmentCurve>(Uv{0.1, 0.5}, Uv{0.9, 0.5})},
                           {size_of(0.02), units(0.05)}});
  for (const double u : {0.2, 0.5, 0.8}) {
    EXPECT_NEAR(mean_near(sources, {u, 0.5}, 0.05), 0.02, kTolerance * 0.02) << u;
  }
}

TEST_P(SizesOn, HoldInsideAPolygon) {
  Sources sources;
  sources.inside.push_back({0, {{0.2, 0.2}, {0.7, 0.2}, {0.7, 0.7}, {0.2, 0.7}}, {size_of(0.03)}});
  EXPECT_NEAR(mean_near(sources, {0.45, 0.45}, 0.2), 0.03, kTolerance * 0.03);
}

TEST_P(SizesOn, HoldNearAPlaceInSpace) {
  Sources sources;
  sources.near.push_back({{at({0.3, 0.6})}, {size_of(0.02), units(0.1)}});
  EXPECT_NEAR(mean_near(sources, {0.3, 0.6}, 0.08), 0.02, kTolerance * 0.02);
}

TEST_P(SizesOn, HoldInsideABoxInSpace) {
  Sources sources;
  const Vec3 reach(0.2, 0.2, 0.1), centre = at({0.5, 0.5});
  sources.boxes.push_back({{centre - reach, centre + reach}, {size_of(0.02)}});
  EXPECT_NEAR(mean_near(sources, {0.5, 0.5}, 0.18), 0.02, kTolerance * 0.02);
}

TEST_P(SizesOn, HoldInABoxOnlyOnPatchesThatAreThere) {
  Sources sources;
  const Vec3 up(0, 0, 2), one = Vec3::Ones();
  sources.boxes.push_back({{at({0.5, 0.5}) + up, at({0.5, 0.5}) + up + one}, {size_of(0.02)}});
  EXPECT_GT(mean_near(sources, {0.5, 0.5}, 0.3), 0.15);
}

// Less than one in a hundred of the points that tell whether a grid is fine enough lie inside.
TEST_P(SizesOn, HoldInsideASmallPolygonOnAGridToo) {
  Sources sources;
  sources.inside.push_back(
      {0, {{0.51, 0.51}, {0.53, 0.51}, {0.53, 0.53}, {0.51, 0.53}}, {size_of(0.002)}});
  PipelineOptions options = coarse();
  options.control.kind = ControlKind::Grid;
  const Where inside = within(at({0.52, 0.52}), 0.008);
  EXPECT_NEAR(mean_length(mesh_model(model_, sources, options).mesh, inside), 0.002, 0.5 * 0.002);
}

TEST_P(SizesOn, HoldInASmallBoxWithoutGradation) {
  Sources sources;
  const Vec3 reach(0.02, 0.02, 0.1), centre = at({0.37, 0.61});
  sources.boxes.push_back({{centre - reach, centre + reach}, {size_of(0.005)}});
  PipelineOptions options = coarse();
  options.sizing.grade = 0;
  const Where inside = within(centre, 0.015);
  EXPECT_NEAR(mean_length(mesh_model(model_, sources, options).mesh, inside), 0.005, 0.25 * 0.005);
}

TEST_P(SizesOn, AreRefusedOnPatchesThatAreNotThere) {
  Sources sources;
  sources.boxes.push_back({{Vec3::Zero(), Vec3::Ones()}, {size_of(0.1)}, {3}});
  EXPECT_EQ(error_of([&] { mesh_model(model_, sources, coarse()); }),
            "invalid input: sources.boxes[0]: it names patch 3, but the model has 1 patch, counted "
            "from 0");
}

TEST_P(SizesOn, FollowAField) {
  Sources sources;
  sources.fields.push_back({0, [](Uv uv, const Vec3&) { return 0.02 + 0.05 * uv.u; }});
  EXPECT_NEAR(mean_near(sources, {0.8, 0.5}, 0.15), 0.06, kTolerance * 0.06);
  EXPECT_NEAR(mean_near(sources, {0.1, 0.5}, 0.08), 0.025, kTolerance * 0.025);
}

TEST_P(SizesOn, FollowATable) {
  Sources sources;
  TableSource table{.patch = 0, .nodes = {}};
  for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0})
      table.nodes.push_back({{u, v}, size_of(0.02 + 0.05 * u)});
  }
  sources.tables.push_back(table);
  EXPECT_NEAR(mean_near(sources, {0.8, 0.5}, 0.15), 0.06, kTolerance * 0.06);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SizesOn, ::testing::Values("square", "cage"),
                         [](const auto& test) { return test.param; });

TEST(SizesOfContours, FollowTheirCurvature) {
  const Model model = testing::square_with_hole(0.2);
  PipelineOptions options = coarse();
  options.sizing.curvature = 0.25;
  const Where rim = [](const Vec3& p) { return p.norm() < 0.2; };
  EXPECT_NEAR(mean_length(mesh_model(model, {}, options).mesh, rim), 0.05, kTolerance * 0.05);
  options.sizing.contour_curvature = false;
  EXPECT_GT(mean_length(mesh_model(model, {}, options).mesh, rim), 0.1);
}

TEST(SizesOfContours, FillGaps) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 0.05)});
  PipelineOptions options = coarse();
  options.sizing.proximity = 3;
  const PolyMesh mesh = mesh_model(model, {}, options).mesh;
  const Where middle = [](const Vec3& p) { return std::abs(p.x() - 0.5) < 0.3; };
  EXPECT_NEAR(mean_length(mesh, middle), 0.05 / 3 * 1.6, 0.3 * 0.05 / 3 * 1.6);
}

TEST(SizesOfContours, ShrinkBesideAShortOne) {
  const Model model = testing::square_with_hole(0.01);
  PipelineOptions options = coarse();
  options.sizing.features = true;
  const Where beside = within(Vec3::Zero(), 0.06);
  const double length = mean_length(mesh_model(model, {}, options).mesh, beside);
  EXPECT_GT(length, 0.01);
  EXPECT_LT(length, 0.09);
}

TEST(ClampedSizes, AreCountedInOneWarning) {
  Sources sources;
  sources.everywhere = {{0, size_of(0.1)}, {0, size_of(9)}, {0, size_of(1e-9, 0.1)}};
  PipelineOptions options = coarse();
  options.sizing.hmin = units(0.05);
  const auto warnings = texts_of(
      mesh_model(testing::unit_square(), sources, options).report.notices, Severity::Warning);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("2 sizes of sources")) << warnings[0];
}

/// The texts of shortfalls for a size that swings about 0.1 at this frequency.
std::vector<std::string> told_of_swings(double frequency) {
  Sources sources;
  sources.fields.push_back(
      {0, [=](Uv uv, const Vec3&) { return 0.1 + 0.05 * std::sin(frequency * uv.u); }});
  return texts_of(mesh_model(testing::unit_square(), sources, coarse()).report.notices,
                  Severity::Shortfall);
}

TEST(FieldThatSwings, IsToldWhereElementsCannotFollow) {
  EXPECT_EQ(told_of_swings(5), std::vector<std::string>());
  const auto told = told_of_swings(1e9);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(told[0].starts_with("patch p0: sizes go up and down within two elements")) << told[0];
}

TEST(SmallSource, IsSeenByElementsThatAreMuchLargerWithoutGradation) {
  const Model model = testing::model_of({testing::rectangle(-6, -6, 6, 6)});
  Sources sources;
  sources.everywhere.push_back({0, size_of(3)});
  sources.at.push_back({0, {1.3, 0.7}, size_of(0.02), units(0.3)});
  PipelineOptions options = coarse();
  options.sizing.hmax = units(3);
  options.sizing.grade = 0;
  const MeshResult result = mesh_model(model, sources, options);
  EXPECT_NEAR(mean_length(result.mesh, within(Vec3(1.3, 0.7, 0), 0.25)), 0.02, 0.15 * 0.02);
}

/// The options of a mesh whose sizes come from curvature alone.
PipelineOptions from_curvature() {
  PipelineOptions options;
  options.sizing = {.curvature = 0.25, .hmin = units(0.02), .hmax = units(1)};
  options.sizing.contour_curvature = options.sizing.features = false;
  options.sizing.proximity = 0;
  return options;
}

TEST(Adaptation, OfAMeshToItsOwnMetricKeepsItsSizes) {
  const Model model = testing::model_of({testing::whole_torus()});
  const MeshResult first = mesh_model(model, {}, from_curvature());
  Sources sources;
  sources.tables = tables_from_mesh(first.mesh);
  PipelineOptions options = from_curvature();
  options.sizing.curvature = 0;
  const MeshResult second = mesh_model(model, sources, options);
  const auto count = static_cast<double>(first.report.mesh.triangles);
  EXPECT_NEAR(static_cast<double>(second.report.mesh.triangles), count, 0.1 * count);
  EXPECT_GT(second.report.edges.unit_fraction, 0.98);
}

TEST(Adaptation, OfASphereToItsOwnMetricKeepsItsSizesAtThePoles) {
  const Model model = testing::model_of({testing::sphere()});
  PipelineOptions options = coarse();
  Sources sources;
  sources.everywhere.push_back({0, size_of(0.1)});
  const MeshResult first = mesh_model(model, sources, options);
  Sources tables;
  tables.tables = tables_from_mesh(first.mesh);
  const MeshResult second = mesh_model(model, tables, options);
  const auto count = static_cast<double>(first.report.mesh.triangles);
  EXPECT_NEAR(static_cast<double>(second.report.mesh.triangles), count, 0.15 * count);
  const Where pole = [](const Vec3& p) { return std::abs(p.z()) > 0.95; };
  const double length = mean_length(first.mesh, pole);
  EXPECT_NEAR(mean_length(second.mesh, pole), length, kTolerance * length);
}

TEST(Adaptation, FollowsTheMetricThatASimulationWrites) {
  const Model model = testing::unit_square();
  MeshResult first = mesh_model(model, {}, coarse());
  const auto uv = require(first.mesh, keys::corner_uv);
  const auto metric = require(first.mesh, keys::corner_metric);
  for (const HalfedgeHandle heh : first.mesh.halfedges()) {
    if (first.mesh.is_boundary(heh)) continue;
    // Layers along v near u = 0.
    const double across = 0.02 + 0.1 * first.mesh.property(uv, heh).u;
    first.mesh.property(metric, heh) = {1 / (across * across), 0, 1 / 0.01};
  }
  Sources sources;
  sources.tables = tables_from_mesh(first.mesh);
  PipelineOptions options = coarse();
  options.sizing.grade = 0;
  const MeshResult second = mesh_model(model, sources, options);
  // ∫√det M = ∫ 10 / (0.02 + 0.1 u) du, two triangles of √3/4 each a unit.
  const double expected = 100 * std::log(0.12 / 0.02) / (0.25 * std::sqrt(3.0));
  EXPECT_NEAR(static_cast<double>(second.report.mesh.triangles), expected, 0.2 * expected);
}

}  // namespace
}  // namespace surfmesh
