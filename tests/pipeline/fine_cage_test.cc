// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/fine_cage.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "cage/cages.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

std::size_t count_told(const Cage& cage, Length size, PatchKind patches = PatchKind::Auto) {
  PipelineOptions options;
  options.sizing.curvature = 0;
  options.sizing.hmax = size;
  const MeshResult result = mesh_model(model_from_cage(cage, {.patches = patches}), {}, options);
  return static_cast<std::size_t>(
      std::count_if(result.report.notices.begin(), result.report.notices.end(),
                    [](const Notice& notice) { return notice.kind == NoticeKind::FineCage; }));
}

TEST(FineCage, IsToldIfItsEdgesAreNoLongerThanElements) {
  const Cage mesh = testing::triangle_sheet(30, 20);  // edges of 2 % of the diagonal
  EXPECT_EQ(count_told(mesh, Length::percent(5), PatchKind::Faces), 1U);
  EXPECT_EQ(count_told(mesh, Length::percent(0.5), PatchKind::Faces), 0U);
}

TEST(FineCage, IsNoneIfElementsMayBeLargerThanFaces) {
  const Cage cage = testing::torus(40, 30);
  EXPECT_EQ(count_told(cage, Length::percent(10)), 0U);
  EXPECT_EQ(count_told(cage, Length::percent(10), PatchKind::Faces), 1U);
}

TEST(FineCage, IsNoneOfAFewFaces) {
  EXPECT_EQ(count_told(testing::triangle_sheet(10, 10), Length::percent(20)), 0U);
}

}  // namespace
}  // namespace surfmesh
