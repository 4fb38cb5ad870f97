// SPDX-License-Identifier: BSD-3-Clause
// Loops that nearly meet, with sizes that know nothing of it: as polylines they would cross.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using Json = nlohmann::json;

struct Circle {
  double u, v, radius;
  double phase = 0;  ///< radians, of its node
};

struct Gap {
  std::string name;
  bool has_round_rim;  ///< the first circle; else the rim is that of the rectangle 2 × 1
  std::vector<Circle> circles;
};

void PrintTo(const Gap& gap, std::ostream* out) { *out << gap.name; }

Json contour(const std::string& name, const Circle& circle) {
  const auto along = [&](double middle, const char* function) {
    return std::to_string(middle) + "+" + std::to_string(circle.radius) + "*" + function + "(t+" +
           std::to_string(circle.phase) + ")";
  };
  return {{"name", name},
          {"range", {0, "2*pi"}},
          {"on", {{{"patch", "p"}, {"u", along(circle.u, "cos")}, {"v", along(circle.v, "sin")}}}}};
}

Json model_with(const Gap& gap) {
  Json loops = Json::array(), contours = Json::array();
  if (!gap.has_round_rim) loops.push_back({"p:v0", "p:u1", "-p:v1", "-p:u0"});
  for (const Circle& circle : gap.circles) {
    const std::string name = std::string("c").append(std::to_string(contours.size()));
    const bool is_rim = gap.has_round_rim && contours.empty();
    contours.push_back(contour(name, circle));
    loops.push_back({std::string(is_rim ? "" : "-").append(name)});
  }
  return {{"patches",
           {{{"name", "p"},
             {"surface", {{"z", "0"}}},
             {"domain", {{"u", {0, 2}}, {"v", {0, gap.has_round_rim ? 2 : 1}}}},
             {"loops", loops}}}},
          {"contours", contours}};
}

/// The ring between the circles of radius 1 and less.
Gap narrow_ring(double width) { return {"NarrowRing", true, {{1, 1, 1}, {1, 1, 1 - width, 0.37}}}; }

TEST(ThinGaps, GetTheRowsAskedForWhateverHmax) {
  const TestFolder folder;
  const double width = 0.01;
  write_text(folder / "a.json", model_with(narrow_ring(width)).dump());
  const ModelInput input = load_model(folder / "a.json");
  for (const double rows : {1.0, 2.0, 3.0}) {
    // Rows of triangles whose sides along the ring are twice as long as their size across it.
    const double predicted = 0.5 * std::numbers::sqrt3 * rows * rows * 2 * std::numbers::pi / width;
    for (const double hmax : {0.06, 0.2, 1.0}) {
      PipelineOptions options;
      options.sizing = {.hmax = Length::units(hmax), .proximity = rows};
      const MeshResult result = mesh_model(input.model, {}, options);
      const auto count = static_cast<double>(result.report.mesh.triangles);
      EXPECT_NEAR(count, predicted, 0.05 * predicted) << rows << " " << hmax;
      EXPECT_GT(result.report.quality.min, 0.6);
    }
  }
}

TEST(ThinGaps, BetweenLoopsAreSeenAtAnyWidth) {
  const TestFolder folder;
  write_text(folder / "a.json", model_with(narrow_ring(1e-4)).dump());
  const ModelInput input = load_model(folder / "a.json");
  PipelineOptions options;
  options.sizing.proximity = 0;
  testing::expect_valid(mesh_model(input.model, {}, options).mesh);
}

TEST(ThinGaps, AreToldWhereElementsDoNotFit) {
  const TestFolder folder;
  write_text(folder / "a.json", model_with({"HoleNearTheRim", false, {{0.7, 0.302, 0.3}}}).dump());
  const ModelInput input = load_model(folder / "a.json");
  PipelineOptions options;
  EXPECT_EQ(texts_of(mesh_model(input.model, {}, options).report.notices, Severity::Warning),
            std::vector<std::string>{});
  options.sizing.proximity = 0;
  const auto warnings =
      texts_of(mesh_model(input.model, {}, options).report.notices, Severity::Warning);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("triangles are as flat as quality 0.0")) << warnings[0];
  EXPECT_NE(warnings[0].find(", in patch p at (0.69"), std::string::npos) << warnings[0];
}

class ThinGapShapes : public ::testing::TestWithParam<Gap> {};

TEST_P(ThinGapShapes, GiveValidMeshesAtCoarseSizes) {
  const TestFolder folder;
  write_text(folder / "a.json", model_with(GetParam()).dump());
  const ModelInput input = load_model(folder / "a.json");
  for (const double size : {0.05, 0.1, 0.2, 0.4, 1.0}) {
    for (const bool is_gap_seen : {false, true}) {
      SCOPED_TRACE(size);
      PipelineOptions options;
      options.sizing = {.curvature = 0,
                        .hmin = Length::units(is_gap_seen ? 0.02 : 1e-4),
                        .hmax = Length::units(size),
                        .contour_curvature = is_gap_seen,
                        .proximity = is_gap_seen ? 0.1 : 0.0,
                        .features = is_gap_seen};
      const MeshResult result = mesh_model(input.model, {}, options);
      testing::expect_valid(result.mesh);
      EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ThinGapShapes,
    ::testing::Values(Gap{"HoleNearTheRim", false, {{0.7, 0.301, 0.3}}},
                      Gap{"TwoHolesNearlyTouching", false, {{0.6, 0.5, 0.3}, {1.201, 0.5, 0.3}}},
                      Gap{"NarrowAnnulus", true, {{1, 1, 1}, {1, 1, 0.999, 0.37}}},
                      Gap{"HoleNearARoundRim", true, {{1, 1, 1}, {1.2, 1, 0.799, 0.37}}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh
