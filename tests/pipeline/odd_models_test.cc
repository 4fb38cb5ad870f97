// SPDX-License-Identifier: BSD-3-Clause
// Models that once went wrong, named for what they showed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::model_of;

Model formula(SurfaceFormulas formulas, Domain domain = {}) {
  return model_of({std::make_shared<FormulaSurface>(formulas, domain)});
}

TEST(OddModel, ThatIsUndefinedBeyondItsSideIsNotAskedThere) {
  PipelineOptions options;
  options.sizing.curvature = 0;
  options.sizing.hmax = Length::share(0.004);
  const Model model = formula({"u+5*v", "v", "0.05*sin(35*u+3*v)+0*log(u+0.001)"});
  const MeshResult result = mesh_model(model, {}, options);
  testing::expect_valid(result.mesh);
  EXPECT_GT(result.report.quality.min, 0.3);
}

TEST(OddModel, WithoutATangentPlaneInTheMiddleIsMeshed) {
  const Model model = formula({"(u^2+v^2)*u", "(u^2+v^2)*v", "0"}, {-1, 1, -1, 1});
  testing::expect_valid(mesh_model(model).mesh);
}

TEST(OddModel, WithoutATangentPlaneAlongALineIsMeshed) {
  const Model model = formula({"u^3", "v", "sin(3*v)"}, {-1, 1, 0, 1});
  testing::expect_valid(mesh_model(model).mesh);
}

TEST(OddModel, WithTwoPointSidesInARowHasOnePole) {
  const Model model = formula({"u*v*cos(v)", "u*v*sin(v)", "u^2*v"});
  const MeshResult result = mesh_model(model);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(result.report.mesh.euler, 1);
}

/// The cap of the unit sphere around an axis tilted from the pole, which it holds beside its
/// middle.
Model cap_around_a_pole(double radius, double tilt) {
  const auto rim = std::make_shared<CallableSpaceCurve>([=](double t) -> Vec3 {
    const double angle = t == 1 ? 0 : 2 * std::numbers::pi * t;
    const double x = std::sin(radius) * std::cos(angle), z = std::cos(radius);
    return {x * std::cos(tilt) + z * std::sin(tilt), std::sin(radius) * std::sin(angle),
            z * std::cos(tilt) - x * std::sin(tilt)};
  });
  const double low = std::numbers::pi / 2 - radius - tilt, high = std::numbers::pi / 2;
  const auto meridian = [&](double u) {
    return std::make_shared<SegmentCurve>(Uv{u, low}, Uv{u, high});
  };
  return model_from_patches(
      {{"s",
        std::make_shared<test::Sphere>(1, Domain{0, 2 * std::numbers::pi, 0, high}),
        {{"rim", "seam", "-s:v1", "-seam"}}}},
      {{"rim", rim, {}},
       {"seam", nullptr, {{"s", meridian(2 * std::numbers::pi)}, {"s", meridian(0)}}}});
}

TEST(OddModel, WithARimNearItsPoleIsMeshedAtAnySize) {
  for (const double tilt : {0.1, 0.3, 0.5}) {
    const Model model = cap_around_a_pole(0.6, tilt);
    for (const double size : {0.05, 0.1, 0.2, 0.4, 1.0}) {
      SCOPED_TRACE(::testing::Message() << tilt << " " << size);
      PipelineOptions options;
      options.sizing = {.curvature = 0, .hmax = Length::units(size)};
      const MeshResult result = mesh_model(model, {}, options);
      testing::expect_valid(result.mesh);
      EXPECT_EQ(result.report.mesh.euler, 1);
      EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
      EXPECT_GT(result.report.quality.min, 0.25);
    }
  }
}

TEST(OddModel, WithAUseOfNoPatchIsRefused) {
  Model model = testing::unit_square();
  model.contours[0].uses.push_back({7, model.contours[0].uses[0].curve});
  EXPECT_NE(error_of([&] { mesh_model(model); }).find("patch 7 of 1"), std::string::npos);
}

TEST(OddModel, WithAUseWithoutACurveIsRefused) {
  Model model = testing::unit_square();
  model.contours[0].uses.push_back({0, nullptr});
  EXPECT_NE(error_of([&] { mesh_model(model); }).find("no curve"), std::string::npos);
}

TEST(OddModel, WithASourceOfNoPatchIsRefused) {
  Sources sources;
  sources.at.push_back({5, {0.5, 0.5}, {Length::units(0.1), Length::units(0.1), 0}});
  const std::string error = error_of([&] { mesh_model(testing::unit_square(), sources); });
  EXPECT_NE(error.find("names patch 5, but the model has 1 patch"), std::string::npos) << error;
}

TEST(OddSizes, AreRefusedByName) {
  const auto fault = [](Length hmin, Length hmax) {
    return error_of(
        [&] { mesh_model(testing::unit_square(), {}, {.sizing = {.hmin = hmin, .hmax = hmax}}); });
  };
  EXPECT_EQ(fault(Length::share(0.1), Length::units(-1)),
            "invalid option: hmax = -1 is outside its range: a length above 0 in model units, or a "
            "share of the diagonal up to 100%");
  EXPECT_EQ(
      fault(Length::units(kUnset), Length::units(1)),
      "invalid option: hmin = nan is outside its range: a length above 0 in model units, or a "
      "share of the diagonal up to 100%");
  EXPECT_EQ(fault(Length::share(1), Length::units(0.5)),
            "invalid option: hmin = 100% must not be above hmax = 0.5, set both: they are lengths "
            "of 1.41421 "
            "and 0.5");
}

TEST(OddModel, WithoutExtentIsRefused) {
  Model model = testing::unit_square();
  model.diagonal = 0;
  EXPECT_NE(error_of([&] { mesh_model(model); }).find("no extent"), std::string::npos);
}

TEST(OddModel, OfWhichAreasCannotBeSquaredIsRefused) {
  Model model = testing::unit_square();
  model.diagonal = 1e-80;
  EXPECT_NE(error_of([&] { mesh_model(model); }).find("too small"), std::string::npos);
  model.diagonal = 1e80;
  EXPECT_NE(error_of([&] { mesh_model(model); }).find("too large"), std::string::npos);
}

}  // namespace
}  // namespace surfmesh
