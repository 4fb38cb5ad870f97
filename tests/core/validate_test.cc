// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/validate.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/expect_valid.hh"
#include "support/meshes.hh"

namespace surfmesh {
namespace {

using testing::disc;
using testing::expect_valid;
using testing::mesh_of;
using testing::octahedron;
using testing::plane_grid;

/// True if a fault of the mesh contains the text.
template <class Mesh>
bool has_fault(const Mesh& mesh, const std::string& text) {
  const std::vector<std::string> faults = find_faults(mesh);
  return std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
    return fault.find(text) != std::string::npos;
  });
}

TEST(MeasureTopology, OfAClosedSurface) {
  const MeshTopology t = measure_topology(octahedron());
  EXPECT_EQ(t.vertices, 6u);
  EXPECT_EQ(t.edges, 12u);
  EXPECT_EQ(t.faces, 8u);
  EXPECT_EQ(t.boundary_edges, 0u);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.euler, 2);
  EXPECT_TRUE(t.is_closed);
}

TEST(MeasureTopology, OfAnOpenSurface) {
  const MeshTopology t = measure_topology(plane_grid(3, 2));
  EXPECT_EQ(t.faces, 12u);
  EXPECT_EQ(t.boundary_edges, 10u);
  EXPECT_EQ(t.split_vertices, 0u);
  EXPECT_EQ(t.euler, 1);
  EXPECT_FALSE(t.is_closed);
}

TEST(MeasureTopology, CountsComponentsAndIsolatedVertices) {
  PolyMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                          {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(measure_topology(mesh).components, 2u);
  mesh.add_vertex({9, 9, 9});
  EXPECT_EQ(measure_topology(mesh).components, 3u);
}

TEST(MeasureTopology, CountsVerticesWhereTwoFansMeet) {
  const PolyMesh mesh =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(measure_topology(mesh).split_vertices, 1u);
}

TEST(MeasureTopology, OfNothingIsNotClosed) {
  EXPECT_EQ(measure_topology(PolyMesh()), MeshTopology());
}

TEST(FindFaults, FindsNoneInProperMeshes) {
  expect_valid(plane_grid(4, 3));
  expect_valid(disc(7));
  expect_valid(octahedron());
  expect_valid(octahedron());
  expect_valid(PolyMesh());
}

TEST(FindFaults, FindsNoneInQuads) {
  expect_valid(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
}

TEST(FindFaults, AllowsIsolatedVertices) {
  PolyMesh mesh = octahedron();
  mesh.add_vertex({9, 9, 9});
  expect_valid(mesh);
}

TEST(FindFaults, FindsAFaceOfAHalfedgeThatIsNotItsOwn) {
  PolyMesh mesh = octahedron();
  mesh.set_face_handle(mesh.halfedge_handle(FaceHandle(2)), FaceHandle(5));
  EXPECT_TRUE(has_fault(mesh, "face 2 has a halfedge of another face"));
  EXPECT_TRUE(has_fault(mesh, "face 5: its halfedges are not one cycle"));
}

TEST(FindFaults, FindsANextThatSkipsAnEdge) {
  PolyMesh mesh = octahedron();
  const HalfedgeHandle heh = mesh.halfedge_handle(FaceHandle(0));
  mesh.set_next_halfedge_handle(heh, mesh.prev_halfedge_handle(heh));
  EXPECT_TRUE(has_fault(mesh, "next and previous do not undo each other"));
  EXPECT_TRUE(has_fault(mesh, "the next one does not start where it ends"));
}

TEST(FindFaults, FindsAHandleOutOfRange) {
  PolyMesh mesh = octahedron();
  mesh.set_vertex_handle(HalfedgeHandle(3), VertexHandle(99));
  EXPECT_TRUE(has_fault(mesh, "halfedge 3 refers to an element that does not exist"));
}

TEST(FindFaults, FindsABoundaryVertexWithAnInnerHalfedge) {
  PolyMesh mesh = plane_grid(2, 2);
  const VertexHandle vh(0);
  const HalfedgeHandle inner =
      mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(mesh.halfedge_handle(vh)));
  ASSERT_EQ(mesh.from_vertex_handle(inner), vh);
  ASSERT_FALSE(mesh.is_boundary(inner));
  mesh.set_halfedge_handle(vh, inner);
  EXPECT_TRUE(has_fault(mesh, "vertex 0 lies on the boundary, but its halfedge does not"));
}

TEST(FindFaults, FindsAVertexWithAHalfedgeOfAnother) {
  PolyMesh mesh = octahedron();
  mesh.set_halfedge_handle(VertexHandle(4), mesh.halfedge_handle(VertexHandle(5)));
  EXPECT_TRUE(has_fault(mesh, "vertex 4 has a halfedge that starts elsewhere"));
}

TEST(FindFaults, FindsAnEdgeFromAVertexToItself) {
  PolyMesh mesh = octahedron();
  const HalfedgeHandle heh(0);
  mesh.set_vertex_handle(heh, mesh.from_vertex_handle(heh));
  EXPECT_TRUE(has_fault(mesh, "edge 0 goes from vertex"));
}

TEST(FindFaults, FindsTwoEdgesBetweenTheSameVertices) {
  // Two triangles on the same three points, glued along one edge only.
  PolyMesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.to_vertex_handle(heh) == VertexHandle(3)) mesh.set_vertex_handle(heh, VertexHandle(2));
  }
  EXPECT_TRUE(has_fault(mesh, "both join the vertices 0 and 2"));
  EXPECT_TRUE(has_fault(mesh, "both join the vertices 1 and 2"));
}

TEST(FindFaults, FindsAnEdgeWithoutAFace) {
  PolyMesh mesh = octahedron();
  mesh.new_edge(VertexHandle(0), VertexHandle(2));
  EXPECT_FALSE(find_faults(mesh).empty());
}

TEST(FindFaults, FindsAFaceWhoseHalfedgesAreNotOneCycle) {
  PolyMesh mesh = octahedron();
  // Dissolve the edge between faces 0 and 1 by hand.
  HalfedgeHandle shared;
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.face_handle(heh) == FaceHandle(0) &&
        mesh.face_handle(mesh.opposite_halfedge_handle(heh)) == FaceHandle(1)) {
      shared = heh;
    }
  }
  const HalfedgeHandle after = mesh.next_halfedge_handle(shared);
  mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(shared), after);
  EXPECT_FALSE(find_faults(mesh).empty());
}

TEST(FindFaults, TellsAtMostAHundredOfAKind) {
  PolyMesh mesh = plane_grid(20, 20);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    mesh.set_vertex_handle(heh, mesh.from_vertex_handle(heh));
  }
  EXPECT_LE(find_faults(mesh).size(), 700u);
  EXPECT_GE(find_faults(mesh).size(), 100u);
}

}  // namespace
}  // namespace surfmesh
