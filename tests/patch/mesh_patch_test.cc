// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/mesh_patch.hh"

#include <gtest/gtest.h>

#include "support/assembled.hh"
#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/models.hh"

namespace surfmesh {
namespace {

class MeshPatch : public ::testing::Test {
 protected:
  PatchTask task() const {
    const auto nodes = place_contour_nodes(model_, {&field_}).contours;
    return {.surface = model_.surface(0),
            .field = field_,
            .boundary = collect_boundary(model_, 0, nodes, NodeNumbers(model_, nodes), field_)};
  }

  Model model_ = testing::square_with_hole(0.3);
  testing::SpaceSizeField field_{model_.surface(0), 0.1};
};

TEST_F(MeshPatch, GivesTheSameMeshForTheSameTask) {
  const PatchResult a = mesh_patch(task()), b = mesh_patch(task());
  ASSERT_EQ(a.mesh.mesh->n_vertices(), b.mesh.mesh->n_vertices());
  for (const VertexHandle vh : a.mesh.mesh->vertices()) {
    EXPECT_EQ(a.mesh.mesh->point(vh), b.mesh.mesh->point(vh));
  }
  EXPECT_EQ(a.queries, b.queries);
}

TEST_F(MeshPatch, TellsWhatEachStageTook) {
  const PatchResult result = mesh_patch(task());
  for (const Stage stage : {Stage::Triangulate, Stage::Refine, Stage::Improve}) {
    EXPECT_GT(result.seconds[stage], 0) << name(stage);
  }
  EXPECT_FALSE(result.is_given_up);
  EXPECT_EQ(result.turned.count, 0U);
}

TEST_F(MeshPatch, CountsItsElements) {
  const RunContext context;
  const std::size_t before = context.elements_left();
  const PatchResult result = mesh_patch(task(), context);
  EXPECT_EQ(before - context.elements_left(), result.mesh.mesh->n_faces());
}

/// A rectangle by the nodes of its one loop.
PatchBoundary boundary_of(const std::vector<Uv>& nodes) {
  PatchBoundary boundary;
  boundary.loops.emplace_back();
  for (const Uv& uv : nodes) {
    boundary.loops[0].push_back({uv, static_cast<int>(boundary.loops[0].size()), 0});
  }
  return boundary;
}

TEST_F(MeshPatch, FillsAPatchWithQuads) {
  const auto field = testing::isotropic_field(0.1);
  const std::vector<Uv> loop = testing::with_nodes(testing::kUnitSquare, field);
  const PatchResult result = mesh_patch({.surface = model_.surface(0),
                                         .field = field,
                                         .boundary = boundary_of(loop),
                                         .quads = {.is_on = true}});
  EXPECT_EQ(result.mesh.mesh->n_faces(), 100u);
  EXPECT_GT(result.seconds[Stage::Quad], 0);
  EXPECT_GT(result.queries[Stage::Quad].total(), 0u);
}

TEST_F(MeshPatch, TellsTheTriangleThatIsLeftBetweenAnOddNumberOfNodes) {
  PatchTask odd = task();
  odd.quads.is_on = true;
  const std::size_t nodes = odd.boundary.loops[0].size() + odd.boundary.loops[1].size();
  ASSERT_EQ(nodes % 2, 1u);  // the hole has 19 segments
  const PatchResult result = mesh_patch(std::move(odd));
  std::size_t triangles = 0;
  for (const FaceHandle fh : result.mesh.mesh->faces()) {
    triangles += result.mesh.mesh->valence(fh) == 3 ? 1 : 0;
  }
  EXPECT_EQ(triangles, 1u);
}

TEST_F(MeshPatch, EndsWhereThereAreTooManyElements) {
  const RunContext context(nullptr, 10);
  EXPECT_EQ(error_of([&] { mesh_patch(task(), context); }),
            "limit: more than max_elements = 10 triangles");
}

}  // namespace
}  // namespace surfmesh
