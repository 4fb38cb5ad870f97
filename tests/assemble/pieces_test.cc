// SPDX-License-Identifier: BSD-3-Clause
// Patches that come in several pieces.
#include <gtest/gtest.h>

#include <memory>

#include "support/cut_patches.hh"
#include "support/expect_valid.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

using testing::CutPatches;

TEST(Pieces, OfASquareAreJoined) {
  CutPatches square(testing::unit_square(), 0.1);
  const std::size_t faces = square.pieces[0].mesh->n_faces() + square.pieces[1].mesh->n_faces();
  PolyMesh mesh;
  EXPECT_TRUE(square.assemble_into(mesh).notices.empty());
  testing::expect_valid(mesh);
  const MeshTopology topology = measure_topology(mesh);
  EXPECT_EQ(topology.faces, faces);
  EXPECT_EQ(topology.euler, 1);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.split_vertices, 0u);
  std::size_t segments = 0;
  for (const ContourNodes& nodes : square.nodes) {
    segments += static_cast<std::size_t>(nodes.segment_count());
  }
  EXPECT_EQ(topology.boundary_edges, segments);
}

TEST(Pieces, OfATorusAreJoinedAtTheCutsAndAtTheSeams) {
  for (const int patches : {1, 2, 3}) {
    CutPatches torus(testing::torus_of(patches), 0.4);
    PolyMesh mesh;
    EXPECT_TRUE(torus.assemble_into(mesh).notices.empty());
    testing::expect_valid(mesh);
    const MeshTopology topology = measure_topology(mesh);
    EXPECT_EQ(topology.euler, 0);
    EXPECT_TRUE(topology.is_closed);
    EXPECT_EQ(topology.components, 1u);
  }
}

TEST(Pieces, GiveNodesBetweenThemTheirNumbersAndPlaces) {
  CutPatches square(testing::unit_square(), 0.1);
  const int first = square.numbers.contour_count(), end = square.numbers.count();
  ASSERT_EQ(end - first, 9);
  PolyMesh mesh;
  square.assemble_into(mesh);
  for (int v = first; v < end; ++v) {
    const VertexHandle vh(v);
    EXPECT_FALSE(mesh.is_boundary(vh));
    EXPECT_NEAR(mesh.point(vh)[0], 0.5, 1e-15);
    EXPECT_NEAR(mesh.point(vh)[1], 0.1 * (v - first + 1), 1e-15);
  }
}

TEST(Pieces, HaveNoContourAtTheirCut) {
  CutPatches square(testing::unit_square(), 0.1);
  const int first = square.numbers.contour_count(), end = square.numbers.count();
  PolyMesh mesh;
  square.assemble_into(mesh);
  const auto contour = require(mesh, keys::edge_contour);
  for (int v = first; v + 1 < end; ++v) {
    const HalfedgeHandle heh = mesh.find_halfedge(VertexHandle(v), VertexHandle(v + 1));
    ASSERT_TRUE(heh.is_valid());
    EXPECT_EQ(mesh.property(contour, mesh.edge_handle(heh)), -1);
  }
  for (const EdgeHandle eh : mesh.edges()) {
    EXPECT_EQ(mesh.is_boundary(eh), mesh.property(contour, eh) >= 0);
  }
}

TEST(Pieces, KeepTheOrderOfTheirFacesAndTheirPatch) {
  CutPatches torus(testing::torus_of(2), 0.4);
  std::vector<int> expected;
  for (const PatchMesh& piece : torus.pieces) {
    expected.insert(expected.end(), piece.mesh->n_faces(), piece.boundary.patch);
  }
  PolyMesh mesh;
  torus.assemble_into(mesh);
  EXPECT_EQ(mesh.property(require(mesh, keys::face_patch)).data_vector(), expected);
}

TEST(Pieces, OfATurnedPatchGoAroundAsTheOthers) {
  CutPatches squares(testing::opposite_squares(), 0.2);
  PolyMesh mesh;
  squares.assemble_into(mesh);
  testing::expect_valid(mesh);
  EXPECT_EQ(measure_topology(mesh).euler, 1);
  for (const FaceHandle fh : mesh.faces()) EXPECT_GT(mesh.calc_face_normal(fh)[2], 0.9);
}

TEST(Pieces, GiveCornersTheParametersOfTheirPlace) {
  for (const Model& model : {testing::opposite_squares(), testing::torus_of(2)}) {
    CutPatches cut(model, 0.4);
    PolyMesh mesh;
    cut.assemble_into(mesh);
    const auto uv = require(mesh, keys::corner_uv);
    const auto patch = require(mesh, keys::face_patch);
    for (const HalfedgeHandle heh : mesh.halfedges()) {
      if (mesh.is_boundary(heh)) continue;
      const Surface& surface = model.surface(mesh.property(patch, mesh.face_handle(heh)));
      const Vec3 place = surface.evaluate(mesh.property(uv, heh), Order::Position).point;
      EXPECT_LT((place - to_eigen(mesh.point(mesh.to_vertex_handle(heh)))).norm(), 1e-12);
    }
  }
}

/// Links and points of a mesh.
auto contents(const PolyMesh& mesh) {
  std::vector<int> links;
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    for (const OpenMesh::BaseHandle& handle : std::initializer_list<OpenMesh::BaseHandle>{
             mesh.to_vertex_handle(heh), mesh.next_halfedge_handle(heh),
             mesh.prev_halfedge_handle(heh), mesh.face_handle(heh)}) {
      links.push_back(handle.idx());
    }
  }
  for (const VertexHandle vh : mesh.vertices()) links.push_back(mesh.halfedge_handle(vh).idx());
  for (const FaceHandle fh : mesh.faces()) links.push_back(mesh.halfedge_handle(fh).idx());
  return std::pair(links, mesh.property(mesh.points_property_handle()).data_vector());
}

TEST(Pieces, MakeTheSameMeshOnAnyNumberOfThreads) {
  const auto made_on = [](int threads) {
    PolyMesh mesh;
    with_threads(threads, [&] { CutPatches(testing::torus_of(5), 0.2).assemble_into(mesh); });
    return contents(mesh);
  };
  const auto expected = made_on(1);
  EXPECT_EQ(made_on(2), expected);
  EXPECT_EQ(made_on(4), expected);
}

TEST(Pieces, AreFreedAndNotNeededAfterwards) {
  CutPatches torus(testing::torus_of(2), 0.4);
  std::vector<std::weak_ptr<int>> owned;
  for (PatchMesh& piece : torus.pieces) {
    OpenMesh::EPropHandleT<std::shared_ptr<int>> handle;
    piece.mesh->add_property(handle, "test:owned");
    piece.mesh->property(handle, EdgeHandle(0)) = std::make_shared<int>();
    owned.push_back(piece.mesh->property(handle, EdgeHandle(0)));
  }
  PolyMesh mesh;
  torus.assemble_into(mesh);
  for (const auto& pointer : owned) EXPECT_TRUE(pointer.expired());
  testing::expect_valid(mesh);
}

}  // namespace
}  // namespace surfmesh
