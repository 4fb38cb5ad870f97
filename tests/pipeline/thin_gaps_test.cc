// SPDX-License-Identifier: BSD-3-Clause
// Loops that nearly meet, with sizes that know nothing of it: as polylines they would cross.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/folders.hh"
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

class ThinGaps : public ::testing::TestWithParam<Gap> {};

TEST_P(ThinGaps, GiveValidMeshesAtCoarseSizes) {
  const TestFolder folder;
  write_text(folder / "a.json", model_with(GetParam()).dump());
  const ModelInput input = load_model(folder / "a.json");
  for (const double size : {0.05, 0.1, 0.2, 0.4, 1.0}) {
    for (const bool is_gap_seen : {false, true}) {
      SCOPED_TRACE(size);
      PipelineOptions options;
      options.sizing = {.curvature = 0,
                        .hmin = {is_gap_seen ? 0.02 : 1e-4, false},
                        .hmax = {size, false},
                        .contour_curvature = is_gap_seen,
                        .proximity = is_gap_seen ? 0.1 : 0.0,
                        .features = is_gap_seen};
      const MeshResult result = mesh_model(input.model, {}, options);
      testing::expect_valid(result.mesh);
      EXPECT_EQ(result.report.shortfalls, std::vector<std::string>{});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ThinGaps,
    ::testing::Values(Gap{"HoleNearTheRim", false, {{0.7, 0.301, 0.3}}},
                      Gap{"TwoHolesNearlyTouching", false, {{0.6, 0.5, 0.3}, {1.201, 0.5, 0.3}}},
                      Gap{"NarrowAnnulus", true, {{1, 1, 1}, {1, 1, 0.999, 0.37}}},
                      Gap{"HoleNearARoundRim", true, {{1, 1, 1}, {1.2, 1, 0.799, 0.37}}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh
