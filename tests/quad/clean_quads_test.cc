// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/clean_quads.hh"

#include <gtest/gtest.h>

#include "quad/grid_patch.hh"
#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/quad_moves.hh"

namespace surfmesh {
namespace {

using testing::GridPatch;
using testing::wanted_of;

CleaningReport clean(GridPatch& patch) {
  return clean_quads(patch.mesh, patch.editor, patch.geometry, wanted_of(patch), RunContext());
}

/// Replace faces of a patch by others.
void replace(GridPatch& patch, const std::vector<FaceHandle>& old,
             const std::vector<std::vector<VertexHandle>>& cycles) {
  FaceCycles fresh;
  for (const auto& cycle : cycles) fresh.add(cycle);
  std::vector<FaceHandle> made;
  patch.editor.replace(old, fresh, made);
}

/// Faces of inner vertices, by vertex of the compacted mesh.
bool is_regular(const PolyMesh& mesh) {
  for (const VertexHandle vh : mesh.vertices()) {
    if (!mesh.is_boundary(vh) && mesh.valence(vh) != 4) return false;
  }
  return true;
}

void compact(GridPatch& patch) {
  compact_patch(patch.mesh, patch.editor);
  testing::expect_valid(patch.mesh);
}

TEST(CleanQuads, TriesNothingOnALattice) {
  GridPatch patch(6, 5);
  const CleaningReport report = clean(patch);
  EXPECT_EQ(report.tried, 0u);
  EXPECT_EQ(report.changed, 0u);
  EXPECT_EQ(patch.geometry.queries().total(), 0u);
}

TEST(CleanQuads, DissolvesADoublet) {
  GridPatch patch(4, 4);
  const VertexHandle v = patch.editor.add_vertex();
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  patch.geometry.put_between(v, std::vector{at(1, 1), at(2, 2)});
  replace(patch, {patch.face(1, 1)},
          {{at(1, 1), at(2, 1), at(2, 2), v}, {at(2, 2), at(1, 2), at(1, 1), v}});
  EXPECT_GE(clean(patch).changed, 1u);
  compact(patch);
  EXPECT_EQ(patch.mesh.n_faces(), 16u);
  EXPECT_TRUE(is_regular(patch.mesh));
}

TEST(CleanQuads, MendsTheBadQuadsAtATurnedEdge) {
  GridPatch patch(4, 4);
  QuadState state(patch.mesh, patch.editor, patch.geometry, wanted_of(patch));
  Replacement change;
  ASSERT_TRUE(rotate_edge(state, patch.halfedge(patch.vertex(2, 1), patch.vertex(2, 2)),
                          Turn::Clockwise, 100, change));
  std::vector<FaceHandle> made;
  patch.editor.replace(change.old, change.fresh, made);
  ASSERT_LT(testing::least_jacobian(patch), 0.01);
  clean(patch);
  EXPECT_GT(testing::least_jacobian(patch), 0.7);
  compact(patch);
}

TEST(CleanQuads, TakesAQuadTooManyOut) {
  GridPatch patch(5, 5);
  QuadState state(patch.mesh, patch.editor, patch.geometry, wanted_of(patch));
  Replacement change;
  ASSERT_TRUE(
      open_vertex(state, patch.halfedge(patch.vertex(2, 2), patch.vertex(3, 2)), 2, 100, change));
  for (const auto& middle : change.middles)
    patch.geometry.put_between(middle.vertex, middle.others);
  std::vector<FaceHandle> made;
  patch.editor.replace(change.old, change.fresh, made);
  clean(patch);
  compact(patch);
  EXPECT_EQ(patch.mesh.n_faces(), 25u);
  EXPECT_TRUE(is_regular(patch.mesh));
}

/// The quad at (1,0) in the bottom row is turned so that the straight boundary vertex (1,0) is the
/// corner of one quad only: a corner of 180°.
TEST(CleanQuads, MendsAStraightCornerOfTheBoundary) {
  GridPatch patch(4, 3);
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  // The faces (0,0) and (1,0) without the edge between them, cut from (0,0) to (2,1).
  replace(patch, {patch.face(0, 0), patch.face(1, 0)},
          {{at(0, 0), at(1, 0), at(2, 0), at(2, 1)}, {at(2, 1), at(1, 1), at(0, 1), at(0, 0)}});
  ASSERT_NEAR(testing::least_jacobian(patch), 0, 1e-12);
  clean(patch);
  EXPECT_GT(testing::least_jacobian(patch), 0.5);
  compact(patch);
  EXPECT_EQ(measure_topology(patch.mesh).euler, 1);
}

TEST(CleanQuads, ChangesNothingTheSecondTime) {
  GridPatch patch(6, 6);
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  replace(patch, {patch.face(2, 2), patch.face(3, 2)},
          {{at(2, 2), at(3, 2), at(4, 2), at(4, 3)}, {at(4, 3), at(3, 3), at(2, 3), at(2, 2)}});
  EXPECT_GT(clean(patch).changed, 0u);
  EXPECT_EQ(clean(patch).changed, 0u);
}

TEST(CleanQuads, LeavesATriangleAlone) {
  GridPatch patch(4, 4);
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  replace(patch, {patch.face(1, 1)},
          {{at(1, 1), at(2, 1), at(2, 2)}, {at(2, 2), at(1, 2), at(1, 1)}});
  clean(patch);
  compact(patch);
  std::size_t triangles = 0;
  for (const FaceHandle fh : patch.mesh.faces()) triangles += patch.mesh.valence(fh) == 3 ? 1 : 0;
  EXPECT_EQ(triangles, 2u);
}

TEST(CleanQuads, EndsOnceItIsCancelled) {
  GridPatch patch(40, 40);
  testing::Cancelling observer;
  const RunContext context(&observer);
  EXPECT_EQ(error_of([&] {
              clean_quads(patch.mesh, patch.editor, patch.geometry, wanted_of(patch), context);
            }),
            testing::kCancelled);
}

}  // namespace
}  // namespace surfmesh
