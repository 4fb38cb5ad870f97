// SPDX-License-Identifier: BSD-3-Clause
#include "progress_line.hh"

#include <gtest/gtest.h>

#include <numeric>

namespace surfmesh {
namespace {

TEST(RunShare, WeighsStagesOfWhichTheSumIsOne) {
  for (const std::span<const StageWeight> stages :
       {std::span<const StageWeight>(kMeshStages), std::span<const StageWeight>(kControlStages),
        std::span<const StageWeight>(kCheckStages), std::span<const StageWeight>(kViewModelStages),
        std::span<const StageWeight>(kViewMeshStages)}) {
    double sum = 0;
    for (const StageWeight& stage : stages) sum += stage.weight;
    EXPECT_NEAR(sum, 1, 1e-12) << stages.back().stage;
  }
}

TEST(RunShare, GrowsFromStageToStage) {
  RunShare share;
  double last = -1;
  for (const StageWeight& stage : kMeshStages) {
    for (const std::size_t done : {0u, 1u, 2u}) {
      share.progress(stage.stage, done, 2);
      EXPECT_GE(*share.value(), last) << stage.stage;
      last = *share.value();
    }
  }
  EXPECT_NEAR(last, 1, 1e-12);
}

TEST(RunShare, GoesByTheEstimatedElements) {
  RunShare share;
  share.progress("control", 1, 1);
  share.progress("estimate", 1000, 1000);
  EXPECT_EQ(share.stage(), "control");
  share.progress("mesh", 0, 1);
  share.at_work(0);
  EXPECT_NEAR(*share.value(), 0.25, 1e-12);
  share.at_work(400);
  EXPECT_NEAR(*share.value(), 0.25 + 0.4 * 0.55, 1e-12);
  share.at_work(1200);
  EXPECT_NEAR(*share.value(), 0.25 + 0.99 * 0.55, 1e-12);
  share.progress("mesh", 1, 1);
  EXPECT_NEAR(*share.value(), 0.8, 1e-12);
}

TEST(RunShare, CountsEachOfSeveralMeshesAsHalfOfWhatIsLeft) {
  RunShare share;
  share.expect_passes();
  share.progress("boundary", 0, 1);
  EXPECT_NEAR(*share.value(), 0.5 * 0.22, 1e-12);
  share.progress("assemble", 1, 1);
  EXPECT_NEAR(*share.value(), 0.5 * 0.85, 1e-12);
  EXPECT_EQ(share.pass(), 1);
  share.progress("boundary", 0, 1);
  EXPECT_EQ(share.pass(), 2);
  EXPECT_NEAR(*share.value(), 0.5 + 0.25 * 0.22, 1e-12);
}

TEST(RunShare, IsUnknownAtAnUnknownStage) {
  RunShare share;
  share.progress("paint", 1, 2);
  EXPECT_FALSE(share.value());
  EXPECT_EQ(progress_line(share, 1.25, 79, false), "paint 1/2  1.2 s");
}

RunShare half_way() {
  RunShare share;
  share.progress("mesh", 3, 6);
  share.at_work(120000);
  return share;
}

TEST(ProgressLine, HasABar) {
  EXPECT_EQ(progress_line(half_way(), 1.4, 79, false),
            "mesh 3/6  [############............]  52 %  120000 elements  1.4 s");
  EXPECT_EQ(progress_line(half_way(), 1.4, 79, true),
            "mesh 3/6  ████████████░░░░░░░░░░░░  52 %  120000 elements  1.4 s");
}

TEST(ProgressLine, FitsAnyWidth) {
  EXPECT_EQ(progress_line(half_way(), 1.4, 50, false),
            "mesh 3/6  [####....]  52 %  120000 elements  1.4 s");
  EXPECT_EQ(progress_line(half_way(), 1.4, 40, false), "mesh 3/6   52 %  120000 elements  1.4 s");
  for (std::size_t width = 1; width < 100; ++width) {
    EXPECT_LE(progress_line(half_way(), 1.4, width, false).size(), width);
  }
}

}  // namespace
}  // namespace surfmesh
