// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/stage.hh"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace surfmesh {
namespace {

TEST(Stage, HasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Stage stage : kStages) names.insert(name(stage));
  EXPECT_EQ(names.size(), kStages.size());
  EXPECT_EQ(names.count("unknown"), 0U);
}

TEST(Stage, IsListedInItsOrder) {
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kStages[i]), i);
  }
  EXPECT_EQ(kStages.back(), Stage::Write);
}

TEST(Stage, IsMeshingFromTheBoundaryToTheLastImprovement) {
  for (const Stage stage : {Stage::Read, Stage::Control, Stage::Write}) {
    EXPECT_FALSE(is_meshing(stage)) << name(stage);
  }
  for (const Stage stage : {Stage::Boundary, Stage::Quad, Stage::Assemble, Stage::Across}) {
    EXPECT_TRUE(is_meshing(stage)) << name(stage);
  }
}

TEST(PerStage, SumsEveryStage) {
  PerStage<int> counts;
  EXPECT_EQ(counts.sum(), 0);
  for (const Stage stage : kStages) counts[stage] = 1;
  EXPECT_EQ(counts.sum(), static_cast<int>(kStages.size()));
  EXPECT_EQ(counts.sum(is_meshing), 7);
}

TEST(PerStage, AddsStageByStage) {
  PerStage<int> a, b;
  a[Stage::Quad] = 1;
  b[Stage::Quad] = 2;
  b[Stage::Read] = 3;
  a += b;
  EXPECT_EQ(a[Stage::Quad], 3);
  EXPECT_EQ(a[Stage::Read], 3);
  EXPECT_EQ(a[Stage::Write], 0);
}

}  // namespace
}  // namespace surfmesh
