// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/copy_mesh.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// Two triangles with a property of each kind of element.
void make_square(PolyMesh& mesh) {
  std::array<VertexHandle, 4> v;
  for (int i = 0; i < 4; ++i) {
    v[static_cast<std::size_t>(i)] = mesh.add_vertex({i % 3 != 0 ? 1.0 : 0.0, i / 2 * 1.0, 0.25});
  }
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[2], v[3]);
  attach(mesh, keys::vertex_uv, Uv{0.5, 0.25});
  attach(mesh, keys::corner_uv, Uv{3, 4});
  attach(mesh, keys::edge_contour, 7);
  attach(mesh, keys::face_patch, 2);
  mesh.property(require(mesh, keys::edge_contour), OpenMesh::EdgeHandle(3)) = 9;
}

TEST(CopyMesh, KeepsAll) {
  PolyMesh mesh;
  make_square(mesh);
  const auto copy = copy_of(mesh);
  ASSERT_EQ(copy->n_vertices(), 4u);
  ASSERT_EQ(copy->n_edges(), 5u);
  ASSERT_EQ(copy->n_faces(), 2u);
  for (const VertexHandle vh : mesh.vertices()) {
    EXPECT_EQ(copy->point(vh), mesh.point(vh));
    EXPECT_EQ(copy->property(require(*copy, keys::vertex_uv), vh), (Uv{0.5, 0.25}));
  }
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    EXPECT_EQ(copy->to_vertex_handle(heh), mesh.to_vertex_handle(heh));
    EXPECT_EQ(copy->next_halfedge_handle(heh), mesh.next_halfedge_handle(heh));
    EXPECT_EQ(copy->face_handle(heh), mesh.face_handle(heh));
    EXPECT_EQ(copy->property(require(*copy, keys::corner_uv), heh), (Uv{3, 4}));
  }
  for (const EdgeHandle eh : mesh.edges()) {
    EXPECT_EQ(copy->property(require(*copy, keys::edge_contour), eh), eh.idx() == 3 ? 9 : 7);
  }
  for (const FaceHandle fh : mesh.faces()) {
    EXPECT_EQ(copy->property(require(*copy, keys::face_patch), fh), 2);
  }
}

TEST(CopyMesh, IsApartFromTheOther) {
  PolyMesh mesh;
  make_square(mesh);
  const auto copy = copy_of(mesh);
  mesh.set_point(VertexHandle(0), {8, 8, 8});
  mesh.property(require(mesh, keys::face_patch), FaceHandle(0)) = 5;
  EXPECT_EQ(copy->point(VertexHandle(0)), (OpenMesh::Vec3d{0, 0, 0.25}));
  EXPECT_EQ(copy->property(require(*copy, keys::face_patch), FaceHandle(0)), 2);
}

}  // namespace
}  // namespace surfmesh
