// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/patch_cache.hh"

#include <gtest/gtest.h>

#include "support/assembled.hh"
#include "support/control_nodes.hh"
#include "support/models.hh"
#include "surfmesh/control/control_cells.hh"

namespace surfmesh::detail {
namespace {

/// A square with a hole, meshed once and kept.
class Cache : public ::testing::Test {
 protected:
  Cache() {
    cache_.begin(0, cells(0.1)->mesh());
    cache_.keep({0, 0}, 0.01, mesh_patch(task(0.01)));
  }

  static std::unique_ptr<ControlCells> cells(double size) {
    return std::make_unique<ControlCells>(
        Domain{}, CellCount{2, 2}, [size](Uv uv) { return testing::node(uv, isotropic(size)); },
        ControlSpaceOptions{}, std::vector<ControlNode>());
  }

  PatchTask task(double corrected_sag) const { return task(corrected_sag, field_); }

  PatchTask task(double corrected_sag, const MetricField& field) const {
    const auto nodes = place_contour_nodes(model_, {&field}).contours;
    return {.surface = model_.surface(0),
            .field = field,
            .boundary = collect_boundary(model_, 0, nodes, NodeNumbers(model_, nodes), field),
            .corrected_sag = corrected_sag};
  }

  Model model_ = testing::square_with_hole(0.3);
  testing::SpaceSizeField field_{model_.surface(0), 0.1};
  testing::SpaceSizeField finer_{model_.surface(0), 0.05};
  PatchCache cache_{1};
};

TEST_F(Cache, GivesTheMeshOfTheSameTask) {
  PatchTask same = task(0.01);
  for (BoundaryLoop& loop : same.boundary.loops) {
    for (BoundaryNode& node : loop) node.vertex += 7;
  }
  EXPECT_TRUE(cache_.begin(0, cells(0.1)->mesh()));
  const auto kept = cache_.find({0, 0}, same);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->mesh.mesh->n_faces(), mesh_patch(task(0.01)).mesh.mesh->n_faces());
  EXPECT_EQ(kept->mesh.boundary.loops[0][0].vertex, same.boundary.loops[0][0].vertex);
}

TEST_F(Cache, KnowsTheSizesItKept) {
  EXPECT_TRUE(cache_.begin(0, cells(0.1)->mesh()));
  EXPECT_FALSE(cache_.begin(0, cells(0.2)->mesh()));
  EXPECT_FALSE(PatchCache(1).begin(0, cells(0.1)->mesh()));
}

TEST_F(Cache, ForgetsTheMeshesOfOtherSizes) {
  EXPECT_FALSE(cache_.begin(0, cells(0.2)->mesh()));
  EXPECT_FALSE(cache_.find({0, 0}, task(0.01)).has_value());
}

TEST_F(Cache, GivesNothingForOthers) {
  EXPECT_FALSE(cache_.find({0, 1}, task(0.01)).has_value());
  EXPECT_FALSE(cache_.find({0, 0}, task(0.02)).has_value());
  EXPECT_FALSE(cache_.find({0, 0}, task(0.01, finer_)).has_value());
}

}  // namespace
}  // namespace surfmesh::detail
