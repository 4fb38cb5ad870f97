// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/region_mesh.hh"

#include <gtest/gtest.h>

#include <vector>

#include "support/expect_valid.hh"
#include "support/meshes.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

FacePiece all_faces(const PolyMesh& mesh) {
  FacePiece piece;
  for (const FaceHandle fh : mesh.faces()) piece.push_back(fh);
  return piece;
}

/// The edge between two vertices.
EdgeHandle edge_between(const PolyMesh& mesh, int a, int b) {
  return mesh.edge_handle(mesh.find_halfedge(VertexHandle(a), VertexHandle(b)));
}

TEST(CutRegion, TakesAllFacesWithTheirPoints) {
  const PolyMesh grid = testing::plane_grid(3, 2);
  const RegionMesh region = cut_region(grid, all_faces(grid), std::vector<char>(grid.n_edges(), 0));
  testing::expect_valid(*region.mesh);
  EXPECT_EQ(region.mesh->n_faces(), grid.n_faces());
  EXPECT_EQ(region.mesh->n_vertices(), grid.n_vertices());
  EXPECT_EQ(region.mesh->n_edges(), grid.n_edges());
  for (const VertexHandle vh : region.mesh->vertices()) {
    EXPECT_EQ(region.mesh->point(vh), grid.point(VertexHandle(region.vertices[index(vh)])));
  }
}

TEST(CutRegion, KnowsItsSidesInTheResult) {
  const PolyMesh grid = testing::plane_grid(3, 2);
  const FacePiece piece = {FaceHandle(2), FaceHandle(3)};  // the middle square below
  const RegionMesh region = cut_region(grid, piece, std::vector<char>(grid.n_edges(), 0));
  testing::expect_valid(*region.mesh);
  EXPECT_EQ(region.faces, piece);
  EXPECT_EQ(region.mesh->n_vertices(), 4u);
  ASSERT_EQ(region.sides.size(), region.mesh->n_edges());
  for (const EdgeHandle eh : region.mesh->edges()) {
    const HalfedgeHandle own = region.mesh->halfedge_handle(eh, 0);
    const HalfedgeHandle side = region.sides[index(eh)];
    EXPECT_EQ(region.vertices[index(region.mesh->from_vertex_handle(own))],
              grid.from_vertex_handle(side).idx());
    EXPECT_EQ(region.vertices[index(region.mesh->to_vertex_handle(own))],
              grid.to_vertex_handle(side).idx());
  }
}

TEST(CutRegion, IsCutAlongHeldEdges) {
  // 3 × 2 squares, vertices 0 to 11; the row from 4 to 7 is held: two halves that do not touch.
  const PolyMesh grid = testing::plane_grid(3, 2);
  std::vector<char> is_held(grid.n_edges(), 0);
  for (int v = 4; v < 7; ++v) is_held[index(edge_between(grid, v, v + 1))] = 1;
  const RegionMesh region = cut_region(grid, all_faces(grid), is_held);
  testing::expect_valid(*region.mesh);
  EXPECT_EQ(measure_topology(*region.mesh).components, 2u);
  EXPECT_EQ(region.mesh->n_vertices(), 16u);
  EXPECT_EQ(region.vertices.size(), 16u);
}

TEST(CutRegion, KeepsVerticesInOneWhereACutEnds) {
  const PolyMesh grid = testing::plane_grid(4, 2);
  std::vector<char> is_held(grid.n_edges(), 0);
  for (int v = 5; v < 7; ++v) is_held[index(edge_between(grid, v, v + 1))] = 1;
  const RegionMesh region = cut_region(grid, all_faces(grid), is_held);
  testing::expect_valid(*region.mesh);
  EXPECT_EQ(measure_topology(*region.mesh).components, 1u);
  // 5 lies at the boundary, 6 inside the cut, 7 at its end.
  EXPECT_EQ(region.mesh->n_vertices(), grid.n_vertices() + 2);
}

}  // namespace
}  // namespace surfmesh
