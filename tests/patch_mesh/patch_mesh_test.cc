// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/patch_mesh.hh"

#include <gtest/gtest.h>

#include <utility>

#include "support/assembled.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"

namespace surfmesh {
namespace {

/// The one patch of a model, meshed, with what it was made of.
struct Meshed {
  explicit Meshed(Model made_of, double size = 0.2)
      : model(std::move(made_of)), field(*model.patches[0].surface, size) {
    nodes = place_contour_nodes(model, {&field}).contours;
    const NodeNumbers numbers(model, nodes);
    result = mesh_patch({.surface = *model.patches[0].surface,
                         .field = field,
                         .boundary = collect_boundary(model, 0, nodes, numbers, field)});
  }

  Model model;
  testing::SpaceSizeField field;
  std::vector<ContourNodes> nodes;
  PatchResult result;
};

TEST(PatchMesh, IsAProperMeshInSpace) {
  const Meshed meshed(testing::square_with_hole(0.3));
  const PolyMesh& mesh = *meshed.result.mesh.mesh;
  testing::expect_valid(mesh);
  const auto uv_of = require(mesh, keys::vertex_uv);
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 point =
        meshed.model.surface(0).evaluate(mesh.property(uv_of, vh), Order::Position).point;
    EXPECT_EQ(to_eigen(mesh.point(vh)), point);
  }
}

TEST(PatchMesh, KnowsTheContoursOfItsBoundaryAndNoneInside) {
  const Meshed meshed(testing::square_with_hole(0.3));
  const PolyMesh& mesh = *meshed.result.mesh.mesh;
  const auto contour_of = require(mesh, keys::edge_contour);
  std::vector<int> segments(meshed.model.contours.size(), 0);
  for (const EdgeHandle eh : mesh.edges()) {
    const int contour = mesh.property(contour_of, eh);
    EXPECT_EQ(contour >= 0, mesh.is_boundary(eh));
    if (contour >= 0) ++segments[static_cast<std::size_t>(contour)];
  }
  for (std::size_t c = 0; c < segments.size(); ++c) {
    EXPECT_EQ(segments[c], meshed.nodes[c].segment_count()) << meshed.model.contours[c].name;
  }
}

TEST(PatchMesh, HasNoContourOnTheRingAroundAPole) {
  const Meshed meshed(testing::model_of({testing::sphere()}));
  const PolyMesh& mesh = *meshed.result.mesh.mesh;
  ASSERT_EQ(meshed.result.mesh.boundary.fans.size(), 2U);
  const auto contour_of = require(mesh, keys::edge_contour);
  int on_rings = 0;
  for (const EdgeHandle eh : mesh.edges()) {
    if (mesh.is_boundary(eh) && mesh.property(contour_of, eh) < 0) ++on_rings;
  }
  EXPECT_GT(on_rings, 4);
}

TEST(PatchMesh, IsTheSameAfterItWasReopened) {
  Meshed meshed(testing::square_with_hole(0.3));
  const std::size_t vertices = meshed.result.mesh.mesh->n_vertices();
  const int contour = meshed.result.mesh.boundary.loops[0][0].contour;
  TriangulatedPatch open =
      reopen_patch(std::move(meshed.result.mesh), meshed.model.surface(0), meshed.field);
  EXPECT_EQ(open.points.size(), vertices);
  EXPECT_EQ(find_turned_triangles(open).count, 0U);
  const PatchMesh again = finish_patch(std::move(open));
  testing::expect_valid(*again.mesh);
  EXPECT_EQ(again.mesh->n_vertices(), vertices);
  EXPECT_EQ(again.boundary.loops[0][0].contour, contour);
}

}  // namespace
}  // namespace surfmesh
