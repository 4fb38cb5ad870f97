// SPDX-License-Identifier: BSD-3-Clause
// Tubes, tips and closed shapes that are thinner than elements are long.
#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/quality/sag.hh"

namespace surfmesh {
namespace {

constexpr double kAround = 2 * std::numbers::pi;

Model model_of_formulas(const SurfaceFormulas& formulas, Domain domain) {
  return testing::model_of({std::make_shared<FormulaSurface>(formulas, domain)});
}

Sizing uniform(double size) {
  return {.curvature = 0, .hmin = Length::units(size), .hmax = Length::units(size)};
}

/// Mesh, and expect that nothing is turned, flat or told.
MeshResult expect_good(const Model& model, const Sizing& sizing, double least_quality) {
  MeshResult result = mesh_model(model, {}, {.sizing = sizing});
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  EXPECT_GT(result.report.quality.min, least_quality);
  return result;
}

/// The distance from the surface, which is that of the axis if elements lie flat.
double greatest_distance(const MeshResult& result, const Model& model) {
  return measure_sag(result.mesh, model, SurfaceSearch(model)).max;
}

TEST(ThinTube, HasFourElementsAround) {
  for (const double radius : {0.03, 1e-5}) {
    SCOPED_TRACE(radius);
    const std::string r = std::to_string(radius);
    const Model model =
        model_of_formulas({r + "*cos(u)", r + "*sin(u)", "v"}, {0, kAround, 0, 100});
    const MeshResult result = expect_good(model, uniform(2), 0.6);
    EXPECT_EQ(result.report.mesh.euler, 0);
    // A triangle in the circle is half the radius away from it, a ribbon the whole.
    EXPECT_LT(greatest_distance(result, model), 0.45 * radius);
  }
}

TEST(ThinTube, MayRunAlongEitherParameter) {
  const Model model = model_of_formulas({"0.03*cos(v)", "0.03*sin(v)", "u"}, {0, 100, 0, kAround});
  expect_good(model, uniform(2), 0.6);
}

TEST(ThinTube, OfHalvesIsRound) {
  std::vector<testing::Shape> halves;
  for (const double from : {0.0, 0.5 * kAround}) {
    halves.push_back(
        std::make_shared<FormulaSurface>(SurfaceFormulas{"0.03*cos(u)", "0.03*sin(u)", "v"},
                                         Domain{from, from + 0.5 * kAround, 0, 100}));
  }
  const Model model = testing::model_of(halves);
  const MeshResult result = expect_good(model, uniform(1), 0.6);
  EXPECT_LT(greatest_distance(result, model), 0.45 * 0.03);
}

TEST(ThinTube, ThatIsATorusIsClosed) {
  const Model model =
      model_of_formulas({"(10+0.01*cos(v))*cos(u)", "(10+0.01*cos(v))*sin(u)", "0.01*sin(v)"},
                        {0, kAround, 0, kAround});
  const MeshResult result = expect_good(model, {}, 0.6);
  EXPECT_TRUE(result.report.mesh.is_closed);
  EXPECT_EQ(result.report.mesh.euler, 0);
}

TEST(ThinTip, IsAFanAtAnyAspect) {
  for (const char* height : {"2", "10", "20", "200", "2000"}) {
    SCOPED_TRACE(height);
    const Model model = model_of_formulas({"v*cos(u)", "v*sin(u)", std::string(height) + "*(1-v)"},
                                          {0, kAround, 0, 1});
    const MeshResult result = expect_good(model, {}, 0.6);
    EXPECT_EQ(result.report.mesh.euler, 1);
  }
}

TEST(ThinTip, OfASpindleIsAFan) {
  const Model model = model_of_formulas({"0.001*sin(v)*cos(u)", "0.001*sin(v)*sin(u)", "cos(v)"},
                                        {0, kAround, 0, std::numbers::pi});
  const MeshResult result = expect_good(model, {}, 0.6);
  EXPECT_EQ(result.report.mesh.euler, 2);
}

TEST(ThinTip, DoesNotRefineWidePoles) {
  const Model disc = model_of_formulas({"v*cos(u)", "v*sin(u)", "0"}, {0, kAround, 0, 1});
  const MeshResult result = expect_good(disc, uniform(0.1), 0.6);
  // Hardly more than equilateral triangles of this size.
  EXPECT_LT(double(result.report.mesh.triangles), 1.1 * std::numbers::pi / 0.00433);
}

TEST(ClosedShape, ThinnerThanElementsIsNotFlat) {
  std::vector<testing::Shape> sheets;
  for (const char* z : {"0.01*(1-u^2)*(1-v^2)", "-0.01*(1-u^2)*(1-v^2)"}) {
    sheets.push_back(
        std::make_shared<FormulaSurface>(SurfaceFormulas{"u", "v", z}, Domain{-1, 1, -1, 1}));
  }
  const MeshResult result = expect_good(testing::model_of(sheets), uniform(2), 0.6);
  EXPECT_TRUE(result.report.mesh.is_closed);
}

}  // namespace
}  // namespace surfmesh
