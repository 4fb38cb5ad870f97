// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/pair_triangles.hh"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "support/domain_meshes.hh"
#include "support/expect_valid.hh"
#include "support/quad_meshes.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/patch_geometry.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {
namespace {

const RunContext kContext;

std::size_t count_of(const PolyMesh& mesh, unsigned corners) {
  std::size_t count = 0;
  for (const FaceHandle fh : mesh.faces()) count += mesh.valence(fh) == corners ? 1 : 0;
  return count;
}

/// Squares that are cut along a diagonal, with places and metrics.
struct CutSquares {
  testing::FunctionField field = testing::constant_field({1, 0, 1});
  PolyMesh mesh;
  CutSquares(int columns, int rows) : mesh(testing::plane_grid(columns, rows)) {
    testing::attach_places(mesh, field);
  }
};

TEST(PairTriangles, MakesTheSquaresThatWereCut) {
  CutSquares squares(5, 4);
  FaceEditor editor(squares.mesh);
  EXPECT_EQ(pair_triangles(squares.mesh, editor, kContext), 0u);
  compact_patch(squares.mesh, editor);
  testing::expect_valid(squares.mesh);
  EXPECT_EQ(count_of(squares.mesh, 4), 20u);
  for (const EdgeHandle eh : squares.mesh.edges()) {
    EXPECT_NEAR(squares.mesh.calc_edge_length(eh), 1, 1e-12);
  }
}

TEST(PairTriangles, TakesTheBestPairsFirst) {
  // A unit square cut in two with a flat triangle at its side, which would make a worse quad.
  PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.5, 0.5, 0}},
                                   {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}});
  testing::attach_places(mesh, testing::constant_field({1, 0, 1}));
  FaceEditor editor(mesh);
  EXPECT_EQ(pair_triangles(mesh, editor, kContext), 1u);
  compact_patch(mesh, editor);
  const FaceHandle quad(mesh.valence(FaceHandle(0)) == 4 ? 0 : 1);
  const std::vector<VertexHandle> cycle = testing::cycle_of(mesh, quad);
  EXPECT_EQ(std::set<VertexHandle>(cycle.begin(), cycle.end()),
            (std::set{VertexHandle(0), VertexHandle(1), VertexHandle(2), VertexHandle(3)}));
}

TEST(PairTriangles, MakesNoBadQuads) {
  // Two flat triangles: together a rhombus of 10° corners.
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, -0.09, 0}, {2, 0, 0}, {1, 0.09, 0}}, {{0, 1, 3}, {1, 2, 3}});
  testing::attach_places(mesh, testing::constant_field({1, 0, 1}));
  FaceEditor editor(mesh);
  EXPECT_EQ(pair_triangles(mesh, editor, kContext), 2u);
}

TEST(PairTriangles, JudgesQuadsByTheMetric) {
  // In the metric the same rhombus is a square.
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, -0.09, 0}, {2, 0, 0}, {1, 0.09, 0}}, {{0, 1, 3}, {1, 2, 3}});
  testing::attach_places(mesh, testing::constant_field({1, 0, 1 / (0.09 * 0.09)}));
  FaceEditor editor(mesh);
  EXPECT_EQ(pair_triangles(mesh, editor, kContext), 0u);
}

/// A circle of so many nodes, with a mesh of triangles inside.
std::unique_ptr<PolyMesh> disc_of_triangles(const MetricField& field, int nodes, bool refined) {
  auto delaunay = triangulate_boundary({testing::circle({0.5, 0.5}, 0.5, nodes)}, field).delaunay;
  if (refined) refine(*delaunay, field);
  return delaunay->release();
}

/// Pair and walk. Returns the triangles that are left.
std::size_t fill_with_quads(PolyMesh& mesh, const MetricField& field, std::size_t fixed) {
  FaceEditor editor(mesh);
  const PatchGeometry geometry(mesh, field, fixed);
  pair_triangles(mesh, editor, kContext);
  const std::size_t left = walk_triangles(mesh, editor, geometry, kContext);
  compact_patch(mesh, editor);
  return left;
}

class WalkTriangles : public ::testing::TestWithParam<int> {};

TEST_P(WalkTriangles, LeavesNoneForAnEvenBoundary) {
  const int nodes = 2 * GetParam();
  for (const bool refined : {false, true}) {
    const auto field = testing::isotropic_field(std::numbers::pi / nodes);
    const auto mesh = disc_of_triangles(field, nodes, refined);
    EXPECT_EQ(fill_with_quads(*mesh, field, static_cast<std::size_t>(nodes)), 0u);
    EXPECT_EQ(count_of(*mesh, 4), mesh->n_faces());
    testing::expect_valid(*mesh);
  }
}

TEST_P(WalkTriangles, LeavesOneForAnOddBoundary) {
  const int nodes = 2 * GetParam() + 1;
  for (const bool refined : {false, true}) {
    const auto field = testing::isotropic_field(std::numbers::pi / nodes);
    const auto mesh = disc_of_triangles(field, nodes, refined);
    EXPECT_EQ(fill_with_quads(*mesh, field, static_cast<std::size_t>(nodes)), 1u);
    EXPECT_EQ(count_of(*mesh, 4) + 1, mesh->n_faces());
    EXPECT_EQ(count_of(*mesh, 3), 1u);
    testing::expect_valid(*mesh);
  }
}

INSTANTIATE_TEST_SUITE_P(Nodes, WalkTriangles, ::testing::Values(2, 3, 4, 7, 12, 25, 60));

TEST(WalkTriangles, KeepsTheSidesOfTheBoundary) {
  const auto field = testing::isotropic_field(0.1);
  const auto mesh = disc_of_triangles(field, 30, true);
  fill_with_quads(*mesh, field, 30);
  for (int v = 0; v < 30; ++v) {
    EXPECT_TRUE(
        testing::halfedge_between(*mesh, VertexHandle(v), VertexHandle((v + 1) % 30)).is_valid());
  }
}

/// One flat quad between two triangles, all in a row: the triangles come from both ends.
TEST(WalkTriangles, MergesTwoTrianglesAcrossAQuad) {
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-0.5, 0.5, 0}, {1.5, 0.5, 0}},
                       {{0, 1, 2, 3}, {0, 3, 4}, {1, 5, 2}});
  const auto field = testing::constant_field({1, 0, 1});
  testing::attach_places(mesh, field);
  FaceEditor editor(mesh);
  const PatchGeometry geometry(mesh, field, 6);
  EXPECT_EQ(walk_triangles(mesh, editor, geometry, kContext), 0u);
  compact_patch(mesh, editor);
  testing::expect_valid(mesh);
  EXPECT_EQ(count_of(mesh, 4), 2u);
}

}  // namespace
}  // namespace surfmesh
