// SPDX-License-Identifier: BSD-3-Clause
// What the paper finds comes out of our meshes, too. Times are shown, not tested.
#include "paper/experiment.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "paper/laboratory.hh"
#include "paper/published.hh"
#include "support/errors.hh"

namespace surfmesh::paper {
namespace {

constexpr Interpolation kT = Interpolation::Triangle, kO = Interpolation::Circles,
                        kX = Interpolation::Automatic;

/// By how much a deviation of ours may be greater than the paper's.
constexpr double kDeviation = 0.03;

Experiment example(int number) {
  return Experiment(std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / "paper" /
                    ("example" + std::to_string(number) + ".json"));
}

double count_of(const Outcome& outcome) { return static_cast<double>(outcome.elements()); }

double share_reused(const Outcome& outcome) {
  const QueryCounts answers = outcome.report.control.queries.sum();
  return static_cast<double>(answers.reused) / static_cast<double>(answers.total());
}

TEST(PaperExample1, HasTheDeviationsOfTable1) {
  Experiment first = example(1);
  for (const bool has_quads : {false, true}) {
    for (const Interpolation interpolation : {kT, kO}) {
      const std::string name =
          std::string(has_quads ? "Q_" : "T_") + (interpolation == kT ? "t" : "o");
      const std::vector<double> paper = published::table1(name);
      const Outcome ours = first.run({interpolation}, Way::Paper, has_quads);
      EXPECT_LE(ours.by_triangles.deviation, paper[3] + kDeviation) << name;
      EXPECT_LE(ours.by_circles.deviation, paper[5] + kDeviation) << name;
      // Places of the nodes are chosen so.
      EXPECT_NEAR(count_of(ours) / paper[1], 1, has_quads ? 0.2 : 0.05) << name;
      EXPECT_EQ(ours.report.mesh.triangles, has_quads ? 0 : ours.elements()) << name;
    }
  }
}

TEST(PaperExample1, GivesUpMoreCircumcentresTheNearerTheMetricsHaveToBe) {
  Experiment first = example(1);
  std::size_t before = 0;
  for (const double conformity : {1.0, 0.3, 0.1}) {
    Variant variant{kO};
    variant.conformity = conformity;
    const std::size_t given_up = first.run(variant, Way::Paper).report.refine.unconforming;
    EXPECT_GE(given_up, before);
    before = given_up;
  }
  EXPECT_GT(before, 100U);
}

TEST(PaperExample1, AMeshMadeWithVtIsWorseInVoThanOneMadeWithVo) {
  Experiment first = example(1);
  for (const bool has_quads : {false, true}) {
    const Outcome by_t = first.run({kT}, Way::Paper, has_quads);
    const Outcome by_o = first.run({kO}, Way::Paper, has_quads);
    EXPECT_GT(by_t.by_circles.deviation, by_o.by_circles.deviation + 0.02);
    EXPECT_GT(std::abs(by_t.by_circles.mean - 1), std::abs(by_o.by_circles.mean - 1) + 0.05);
  }
}

TEST(PaperExample2, HasTheDeviationsOfTable2) {
  Experiment second = example(2);
  for (const Variant& variant : variants_of_second()) {
    const std::vector<double> paper = published::table2(label(variant));
    const Outcome ours = second.run(variant, Way::Paper);
    EXPECT_LE(ours.own.deviation, paper[3] + kDeviation) << label(variant);
    EXPECT_LE(ours.by_circles.deviation, paper[5] + kDeviation) << label(variant);
    EXPECT_NEAR(count_of(ours) / 1000 / paper[0], 1, 0.15) << label(variant);
    const Outcome unsmoothed = second.run(variant, Way::Unsmoothed);
    EXPECT_LE(unsmoothed.by_circles.deviation, paper[5] + kDeviation) << label(variant);
  }
}

TEST(PaperExample2, InnerNodesCostAtMostAFifthMoreTriangles) {
  Experiment second = example(2);
  for (const Interpolation interpolation : {kT, kO, kX}) {
    const Outcome without = second.run({interpolation, false}, Way::Paper);
    const Outcome with = second.run({interpolation, true}, Way::Paper);
    EXPECT_EQ(without.report.control.faces, 622U);
    EXPECT_GT(with.report.control.faces, 2 * 622U);
    EXPECT_LE(count_of(with), 1.2 * count_of(without));
  }
}

class PaperExample3 : public ::testing::TestWithParam<int> {
 protected:
  Experiment third_ = example(3);
};

TEST_P(PaperExample3, HasTheDeviationsOfTable4) {
  for (const Variant& variant : {Variant{kX, true, true, GetParam()},
                                 {kX, true, false, GetParam()},
                                 {kO, false, false, GetParam()}}) {
    const std::vector<double> paper = published::table4(GetParam(), label(variant));
    const Outcome ours = third_.run(variant, Way::Paper);
    EXPECT_LE(ours.by_circles.deviation, paper[5] + kDeviation) << label(variant);
    EXPECT_NEAR(count_of(ours) / 1000 / paper[0], 1, 0.12) << label(variant);
  }
}

/// Nor do they cost a triangle.
TEST_P(PaperExample3, NeedsNoInnerNodes) {
  const Outcome without = third_.run({kX, false, false, GetParam()}, Way::Paper);
  const Outcome with = third_.run({kX, true, false, GetParam()}, Way::Paper);
  EXPECT_EQ(with.elements(), without.elements());
  EXPECT_EQ(with.report.control.nodes, static_cast<std::size_t>(GetParam()));
}

/// To within 10 points of a hundred; fewer triangles are of class V_s.
TEST_P(PaperExample3, HasTheSharesOfTable5) {
  const Variant variant{kX, true, true, GetParam()};
  const Outcome ours = third_.run(variant, Way::Paper);
  const std::vector<double> paper = published::table5(GetParam(), label(variant));
  const auto share = [](std::size_t part, std::size_t all) {
    return 100 * static_cast<double>(part) / static_cast<double>(all);
  };
  const QueryCounts m = ours.report.control.queries.sum();
  EXPECT_NEAR(share(m.single, m.total()), paper[0], 10);
  EXPECT_NEAR(share(m.triangle, m.total()), paper[1], 10);
  EXPECT_NEAR(share(m.circles, m.total()), paper[2], 10);
  EXPECT_NEAR(share(m.reused, m.total()), paper[3], 10);
  const Report::Classes& n = ours.report.control.classes;
  EXPECT_NEAR(share(n.single, ours.report.control.faces), paper[4], 10);
  EXPECT_NEAR(share(n.triangle, ours.report.control.faces), paper[5], 10);
  EXPECT_NEAR(share(n.circles, ours.report.control.faces), paper[6], 10);
}

TEST_P(PaperExample3, ReuseAnswersAFifthToTwoFifthsOfTheQuestions) {
  for (const Interpolation interpolation : {kT, kO, kX}) {
    const Outcome with = third_.run({interpolation, true, true, GetParam()}, Way::Paper);
    const Outcome without = third_.run({interpolation, true, false, GetParam()}, Way::Paper);
    EXPECT_GE(share_reused(with), 0.2);
    EXPECT_LE(share_reused(with), 0.4);
    EXPECT_EQ(share_reused(without), 0);
    EXPECT_NEAR(count_of(with) / count_of(without), 1, 0.01);
    for (const Stage stage : kStages) {
      const QueryCounts& asked = with.report.control.queries[stage];
      EXPECT_LE(asked.total() - asked.reused, without.report.control.queries[stage].total())
          << name(stage);
    }
  }
}

TEST_P(PaperExample3, IsBetterByTodaysDefaults) {
  const Variant variant{kX, true, false, GetParam()};
  EXPECT_LT(third_.run(variant, Way::Today).by_circles.deviation,
            0.85 * third_.run(variant, Way::Paper).by_circles.deviation);
}

INSTANTIATE_TEST_SUITE_P(Nodes, PaperExample3, ::testing::Values(40'000, 10'000, 2'500),
                         [](const auto& test) { return std::to_string(test.param); });

TEST(PaperExample, HasOnePatch) {
  const auto path = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / "pipes.json";
  EXPECT_NE(error_of([&] { Experiment experiment(path); }).find("an example has one patch"),
            std::string::npos);
}

TEST(PaperVariant, IsCalledAsInThePaper) {
  EXPECT_EQ(label({kT}), "V_t");
  EXPECT_EQ(label({kX, true, true}), "V_x+IR");
  EXPECT_EQ(label({kO, false, true}), "V_o+R");
}

}  // namespace
}  // namespace surfmesh::paper
