// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/estimate_triangles.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/errors.hh"
#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/estimate/coarse_estimate.hh"
#include "surfmesh/estimate/element_limit.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh {
namespace {

constexpr double kUnitArea = std::numbers::sqrt3 / 4;

TriangleEstimate estimate_of(const Model& model, const Sizing& sizing, const Sources& sources = {},
                             const ControlOptions& control = {}) {
  const ControlSpaces made =
      make_control_spaces(model, sources, resolve(sizing, model.diagonal), control);
  return estimate_triangles(model, made.spaces);
}

Sizing uniform(double size) {
  return {.curvature = 0, .hmin = Length::units(size), .hmax = Length::units(size)};
}

TEST(TriangleEstimate, IsTheAreaByThatOfATriangle) {
  const Model square = testing::model_of({testing::rectangle(0, 0, 2, 3)});
  EXPECT_NEAR(estimate_of(square, uniform(0.1)).triangles(), 6 / (kUnitArea * 0.01), 1e-6 * 1400);
}

TEST(TriangleEstimate, HoldsWhereSizesGrow) {
  // One over the squared size, from the middle line at y = 0 out to 1.
  const Model square = testing::model_of({testing::rectangle(0, -1, 1, 1)});
  Sources sources;
  sources.fields.push_back({0, [](Uv uv, const Vec3&) { return 0.01 + 0.3 * std::abs(uv.v); }});
  const double exact = 2 * (1 / 0.01 - 1 / 0.31) / 0.3 / kUnitArea;
  Sizing sizing = uniform(1);
  sizing.hmin = Length::units(1e-3);
  sizing.grade = 0;
  for (const ControlKind kind : {ControlKind::Cells, ControlKind::Mesh}) {
    EXPECT_NEAR(estimate_of(square, sizing, sources, {.kind = kind}).triangles(), exact,
                0.05 * exact);
  }
}

TEST(TriangleEstimate, LeavesOutHoles) {
  for (const double radius : {0.9, 0.1, 0.01}) {
    const Model plate = testing::square_with_hole(radius);
    Sizing sizing = uniform(0.02);
    sizing.proximity = 0;
    const double exact = (4 - std::numbers::pi * radius * radius) / (kUnitArea * 0.0004);
    EXPECT_NEAR(estimate_of(plate, sizing).triangles(), exact, 0.01 * exact) << radius;
  }
}

TEST(TriangleEstimate, CountsTheBoundaryOfNarrowStrips) {
  const Model strip = testing::model_of({testing::rectangle(0, 0, 100, 0.01)});
  EXPECT_NEAR(estimate_of(strip, uniform(1)).triangles(), 200, 1);
}

TEST(TriangleEstimate, IsNearTheMeshOnPolesTrimsAndWaves) {
  const std::vector<Model> models = {
      testing::model_of({testing::sphere()}), testing::model_of({testing::whole_torus()}),
      testing::square_with_hole(0.3), testing::model_of({testing::sine_wave()}),
      testing::model_of({testing::half_bent_sheet()})};
  for (std::size_t i = 0; i < models.size(); ++i) {
    SCOPED_TRACE(i);
    const MeshResult result =
        mesh_model(models[i], {}, {.sizing = {.curvature = 0.1, .hmax = Length::share(0.05)}});
    const auto made = static_cast<double>(result.report.mesh.triangles);
    EXPECT_NEAR(result.report.estimated_elements, made, 0.06 * made);
  }
}

/// Nodes at poles have no metric.
TEST(TriangleEstimate, IsNearTheMeshBesideExactPoles) {
  for (const double apex : {0.0, 1.0}) {
    const Model cone = testing::model_of(
        {make_callable_surface(Domain{0, 2 * std::numbers::pi, 0, 1}, [=](auto u, auto v) {
          const auto radius = (1 - 2 * apex) * v + apex;
          return std::array{radius * cos(u), radius * sin(u), 3 * radius};
        })});
    for (const ControlKind kind : {ControlKind::Cells, ControlKind::Mesh, ControlKind::Grid}) {
      SCOPED_TRACE(::testing::Message() << apex << " " << static_cast<int>(kind));
      PipelineOptions options;
      options.sizing = {.curvature = 0.1, .hmax = Length::share(0.05)};
      options.control.kind = kind;
      const MeshResult result = mesh_model(cone, {}, options);
      const auto made = static_cast<double>(result.report.mesh.triangles);
      EXPECT_NEAR(result.report.estimated_elements, made, 0.08 * made);
    }
  }
}

TEST(TriangleEstimate, GivesTheHminThatFits) {
  const Model square = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  const TriangleEstimate estimate = estimate_of(square, uniform(0.001));
  const double hmin = estimate.fitting_hmin(10000).value();
  EXPECT_LE(estimate.triangles_with(hmin), 10000);
  EXPECT_NEAR(hmin, std::sqrt(1 / (kUnitArea * 10000)), 0.01 * hmin);
  // Nothing is in the way of a number that is not reached.
  EXPECT_LE(estimate.fitting_hmin(1e9).value(), 0.001);
}

CoarseEstimate coarse_estimate_of(const Model& model, const Sizing& sizing,
                                  const Sources& sources) {
  const ResolvedSizing resolved = resolve(sizing, model.diagonal);
  return estimate_coarsely(model, model_sources(model, sources, resolved), resolved);
}

TEST(CoarseEstimate, IsNearWhereSizesAreEven) {
  const Model model = testing::square_with_hole(0.5);
  const double exact = (4 - std::numbers::pi * 0.25) / (kUnitArea * 1e-8);
  const CoarseEstimate estimate = coarse_estimate_of(model, uniform(1e-4), {});
  EXPECT_NEAR(estimate.likely.triangles(), exact, 0.05 * exact);
  EXPECT_NEAR(estimate.least.triangles(), exact, 0.05 * exact);
  EXPECT_GT(most_triangles(model, 1e-4), exact);
}

TEST(CoarseEstimate, DoesNotTakeANarrowBandForAll) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  Sizing sizing = uniform(0.1);
  sizing.hmin = Length::units(1e-6);
  Sources sources;
  sources.fields.push_back(
      {0, [](Uv uv, const Vec3&) { return std::abs(uv.u - 0.5) < 1e-9 ? 1e-6 : 0.1; }});
  EXPECT_LT(coarse_estimate_of(model, sizing, sources).least.triangles(), 1000);
}

TEST(CoarseEstimate, IsNotInStepWithAPeriodicField) {
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
  Sizing sizing = uniform(1);
  sizing.hmin = Length::units(1e-5);
  Sources sources;
  sources.fields.push_back({0, [](Uv uv, const Vec3&) {
                              const double u = std::sin(32 * std::numbers::pi * uv.u);
                              const double v = std::sin(32 * std::numbers::pi * uv.v);
                              return 1e-4 + 0.2 * u * u + 0.2 * v * v;
                            }});
  EXPECT_LT(coarse_estimate_of(model, sizing, sources).least.triangles(), 1e6);
}

TEST(ElementLimit, NamesHmaxWhereItIsInTheWay) {
  const RunContext context(nullptr, 1000);
  const TriangleEstimate many({{{{4000 * kUnitArea, 1, 1}}, {}}});
  EXPECT_NE(error_of([&] { throw_too_many(many, 1, context); }).find("; size = 2.17"),
            std::string::npos);
}

/// Sizes around tubes do not follow hmin.
TEST(ElementLimit, GivesNoHminWhereNoneHelps) {
  const RunContext context(nullptr, 1000);
  const TriangleEstimate tube({{{{4000 * kUnitArea, 1, 1}}, {}}}, 2);
  EXPECT_EQ(tube.fitting_hmin(1000), std::nullopt);
  EXPECT_NE(error_of([&] { throw_too_many(tube, 10, context); }).find("whatever hmin is"),
            std::string::npos);
}

TEST(ElementLimit, IsNamedWithWhatFits) {
  const RunContext context(nullptr, 1000);
  const TriangleEstimate few({{{{1100 * kUnitArea, 1, 1}}, {}}});
  EXPECT_FALSE(is_surely_above(few, context));
  const TriangleEstimate many({{{{4000 * kUnitArea, 1, 1}}, {}}});
  ASSERT_TRUE(is_surely_above(many, context));
  EXPECT_EQ(error_of([&] { throw_too_many(many, 10, context); }),
            "limit: the sizes ask for about 4e+03 triangles, more than max_elements = 1000; hmin = "
            "2.17 (in model units) would fit");
}

}  // namespace
}  // namespace surfmesh
