// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/loop_steps.hh"

#include <gtest/gtest.h>

#include "support/models.hh"

namespace surfmesh {
namespace {

using testing::model_of;

std::vector<LoopStep> steps_of(const Model& model, std::size_t count) {
  return steps_along(model, model.patch(0).loops.front(), [&](int) { return count; });
}

TEST(LoopSteps, StartWhereTheOneBeforeEnds) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  const std::vector<LoopStep> steps = steps_of(model, 3);
  ASSERT_EQ(steps.size(), 12u);
  const auto point = [&](const LoopEntry& entry, std::size_t node) {
    return model.point(model.use(entry), static_cast<double>(node) / 3);
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const LoopStep& step = steps[i];
    const std::size_t end = step.node == step.segment ? step.node + 1 : step.node - 1;
    const LoopStep& next = steps[(i + 1) % steps.size()];
    EXPECT_LT((point(step.entry, end) - point(next.entry, next.node)).norm(), 1e-15) << i;
  }
}

TEST(LoopSteps, RunBackwardsWhereTheUseDoes) {
  const Model model = testing::square_with_hole(0.5);
  const auto steps = steps_along(model, model.patch(0).loops.back(), [](int) { return 2; });
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].node, 2u);
  EXPECT_EQ(steps[0].segment, 1u);
  EXPECT_EQ(steps[1].node, 1u);
  EXPECT_EQ(steps[1].segment, 0u);
}

TEST(PoleRuns, AreNoneWithoutPoles) {
  const Model model = model_of({testing::rectangle(0, 0, 1, 1)});
  EXPECT_TRUE(pole_runs(model, steps_of(model, 2)).empty());
  EXPECT_FALSE(has_pole(model, model.patch(0)));
}

TEST(PoleRuns, AreTheSidesOfASphere) {
  const Model model = model_of({testing::sphere()});
  // South pole, a seam, north pole, the seam again.
  const std::vector<LoopStep> steps = steps_along(model, model.patch(0).loops.front(), [&](int c) {
    return model.contour(c).is_degenerate ? std::size_t{1} : std::size_t{4};
  });
  const std::vector<PoleRun> runs = pole_runs(model, steps);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].first, 0u);
  EXPECT_EQ(runs[1].first, 5u);
  for (const PoleRun& run : runs) EXPECT_EQ(run.count, 1u);
  EXPECT_TRUE(has_pole(model, model.patch(0)));
}

TEST(PoleRuns, GoOnAtTheBeginning) {
  const Model model = model_of({testing::sphere()});
  // Two steps along the south pole, and the list begins between them.
  const std::vector<LoopStep> steps = steps_of(model, 2);
  std::vector<LoopStep> turned(steps.begin() + 1, steps.end());
  turned.push_back(steps.front());
  const std::vector<PoleRun> runs = pole_runs(model, turned);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[1].first, 7u);
  EXPECT_EQ(runs[1].count, 2u);
}

TEST(PoleRuns, AreNoneWhereAllIsAPole) {
  const Model model = model_of({testing::sphere()});
  std::vector<LoopStep> steps = steps_of(model, 1);
  steps.resize(1);
  ASSERT_TRUE(is_on_pole(model, steps[0]));
  EXPECT_TRUE(pole_runs(model, steps).empty());
}

}  // namespace
}  // namespace surfmesh
