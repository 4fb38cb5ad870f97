// SPDX-License-Identifier: BSD-3-Clause
// Metrics of aspect up to 1,000, through all stages and judged in the exact metric.
#include <gtest/gtest.h>

#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/metric_formulas.hh"
#include "support/notices.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// What BAMG reaches at best on metrics of aspect 10 to 100.
constexpr double kUnitFractionOfPeer = 0.993, kMeanQualityOfPeer = 0.968;

class StrongMetrics : public ::testing::TestWithParam<testing::MetricFormulas> {
 protected:
  StrongMetrics() {
    write_text(folder_ / "model.json", testing::model_text(GetParam()));
    input_ = load_model(folder_ / "model.json");
    result_ = mesh_model(input_.model, input_.sources, input_.options);
  }

  TestFolder folder_;
  ModelInput input_;
  MeshResult result_;
};

TEST_P(StrongMetrics, AreFollowedBetterThanByThePeer) {
  MeshFile file{result_.mesh, {}, {}};
  const ModelFit fit = measure_fit(file, input_, JudgedBy::ExactSizes);
  EXPECT_GE(fit.sizes.edges.unit_fraction, kUnitFractionOfPeer);
  EXPECT_GE(fit.sizes.quality.mean, kMeanQualityOfPeer);
  EXPECT_GE(fit.sizes.quality.min, 0.3);
}

TEST_P(StrongMetrics, GiveAValidMeshWithoutComplaint) {
  testing::expect_valid(result_.mesh);
  EXPECT_EQ(texts_of(result_.report.notices, Severity::Shortfall), std::vector<std::string>{});
  EXPECT_EQ(result_.report.mesh.euler, 1);
}

INSTANTIATE_TEST_SUITE_P(Of, StrongMetrics,
                         ::testing::Values(testing::shock_formulas(), testing::ring_formulas(),
                                           testing::jump_formulas(), testing::layer_formulas(),
                                           testing::crossing_formulas()),
                         [](const auto& test) { return test.param.name; });

TEST(TurningMetric, EndsAtThreeTimesThePredictedCountAndSaysSo) {
  const TestFolder folder;
  write_text(folder / "model.json", testing::model_text(testing::turning_formulas()));
  const ModelInput input = load_model(folder / "model.json");
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  testing::expect_valid(result.mesh);
  ASSERT_EQ(texts_of(result.report.notices, Severity::Shortfall).size(), 2u);
  EXPECT_NE(
      texts_of(result.report.notices, Severity::Shortfall)[0].find("does not hold its precision"),
      std::string::npos);
  EXPECT_NE(
      texts_of(result.report.notices, Severity::Shortfall)[1].find("three times the triangles"),
      std::string::npos);
  // √det M is 1 / (0.3 · 0.0003); the boundary alone makes 14,000 triangles.
  EXPECT_LT(result.report.mesh.triangles, 3 * 25'660 + 15'000);
}

}  // namespace
}  // namespace surfmesh
