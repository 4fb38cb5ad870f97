// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/copy_result.hh"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "support/errors.hh"
#include "support/meshes.hh"
#include "support/quad_meshes.hh"
#include "surfmesh/cage/cage_from_mesh.hh"

namespace surfmesh {
namespace {

struct FloatTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
};
using FloatTriMesh = OpenMesh::TriMesh_ArrayKernelT<FloatTraits>;
using DoublePolyMesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// The mesh with all properties of a result, and contour 3 along its boundary.
PolyMesh with_properties(PolyMesh mesh) {
  if (!find(mesh, keys::corner_uv).is_valid()) testing::attach_plane_properties(mesh);
  const auto contour = attach(mesh, keys::edge_contour, -1);
  for (const EdgeHandle eh : mesh.edges()) {
    if (mesh.is_boundary(eh)) mesh.property(contour, eh) = 3;
  }
  return mesh;
}

/// A flat result of values that are no short decimals.
PolyMesh result(int columns = 4) {
  PolyMesh mesh = with_properties(testing::plane_grid(columns, 3, {1 / 3.0, 0.1, 2 / 3.0}));
  for (const VertexHandle vh : mesh.vertices()) mesh.point(vh) /= 3;
  return mesh;
}

template <class A, class B>
void expect_same_connectivity(const A& a, const B& b) {
  ASSERT_EQ(a.n_vertices(), b.n_vertices());
  ASSERT_EQ(a.n_halfedges(), b.n_halfedges());
  ASSERT_EQ(a.n_faces(), b.n_faces());
  for (const auto heh : a.all_halfedges()) {
    EXPECT_EQ(a.to_vertex_handle(heh), b.to_vertex_handle(heh));
    EXPECT_EQ(a.next_halfedge_handle(heh), b.next_halfedge_handle(heh));
    EXPECT_EQ(a.face_handle(heh), b.face_handle(heh));
  }
  for (const auto vh : a.all_vertices()) EXPECT_EQ(a.halfedge_handle(vh), b.halfedge_handle(vh));
  for (const auto fh : a.all_faces()) EXPECT_EQ(a.halfedge_handle(fh), b.halfedge_handle(fh));
}

/// Equal as bytes: unset values, NaN, are equal, too.
template <class Source, class Target, class Key>
void expect_same_bytes(const Source& source, const Target& target, const Key& key) {
  const auto& a = source.property(require(source, key)).data_vector();
  const auto& b = target.property(require(target, key)).data_vector();
  using Bytes = std::array<std::uint8_t, sizeof(typename Key::Value)>;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::bit_cast<Bytes>(a[i]), std::bit_cast<Bytes>(b[i])) << key.name << ' ' << i;
  }
}

template <class Mesh>
void expect_same_properties(const PolyMesh& source, const Mesh& target) {
  expect_same_bytes(source, target, keys::face_patch);
  expect_same_bytes(source, target, keys::edge_contour);
  expect_same_bytes(source, target, keys::corner_uv);
  expect_same_bytes(source, target, keys::corner_metric);
}

TEST(CopyResult, CopiesNormalsThatAreThere) {
  PolyMesh source = result();
  DoublePolyMesh target;
  copy_result(source, target);
  EXPECT_FALSE(find(target, keys::corner_normal).is_valid());
  EXPECT_FALSE(find(target, keys::corner_beyond).is_valid());
  attach(source, keys::corner_normal, Normal{0, 0.6, -0.8});
  attach(source, keys::corner_beyond, 1);
  copy_result(source, target);
  expect_same_bytes(source, target, keys::corner_normal);
  expect_same_bytes(source, target, keys::corner_beyond);
}

TEST(CopyResult, IsExactInDoubleMeshes) {
  const PolyMesh source = result();
  DoublePolyMesh target;
  copy_result(source, target);
  expect_same_connectivity(source, target);
  expect_same_properties(source, target);
  for (const VertexHandle vh : source.vertices()) EXPECT_EQ(source.point(vh), target.point(vh));
}

TEST(CopyResult, CopiesQuads) {
  const PolyMesh source = with_properties(testing::quad_grid(testing::GridNumbers(5, 4)));
  DoublePolyMesh target;
  copy_result(source, target);
  expect_same_connectivity(source, target);
  expect_same_properties(source, target);
  for (const auto fh : target.faces()) EXPECT_EQ(target.valence(fh), 4u);
}

TEST(CopyResult, RoundsPointsOfFloatMeshes) {
  const PolyMesh source = result();
  FloatTriMesh target;
  copy_result(source, target);
  expect_same_connectivity(source, target);
  expect_same_properties(source, target);
  for (const VertexHandle vh : source.vertices()) {
    EXPECT_EQ(OpenMesh::Vec3f(source.point(vh)), target.point(vh));
  }
}

TEST(CopyResult, WritesWhatTheTargetRequests) {
  const PolyMesh source = result();
  FloatTriMesh target;
  copy_result(source, target);
  EXPECT_FALSE(target.has_face_normals());
  for (const VertexHandle vh : target.vertices()) {
    EXPECT_EQ(target.normal(vh), OpenMesh::Vec3f(0, 0, 1));
  }
  const auto uv_of = require(source, keys::corner_uv);
  for (const HalfedgeHandle heh : source.halfedges()) {
    const Uv uv = source.is_boundary(heh) ? Uv{0, 0} : source.property(uv_of, heh);
    EXPECT_EQ(target.texcoord2D(heh),
              OpenMesh::Vec2f(static_cast<float>(uv.u), static_cast<float>(uv.v)));
  }
}

struct CornerNormalTraits : OpenMesh::DefaultTraits {
  HalfedgeAttributes(OpenMesh::Attributes::Normal);
};

TEST(CopyResult, WritesTheNormalsOfTheSurfaceToCorners) {
  PolyMesh source = result();
  OpenMesh::TriMesh_ArrayKernelT<CornerNormalTraits> target;
  copy_result(source, target);
  EXPECT_EQ(target.normal(target.halfedge_handle(FaceHandle(0))), OpenMesh::Vec3f(0, 0, 1));
  attach(source, keys::corner_normal, Normal{0, 0.6, -0.8});
  copy_result(source, target);
  for (const HalfedgeHandle heh : source.halfedges()) {
    if (source.is_boundary(heh)) continue;
    EXPECT_EQ(target.normal(heh), OpenMesh::Vec3f(0, 0.6f, -0.8f));
  }
}

TEST(CopyResult, ReplacesWhatTheTargetHeld) {
  const PolyMesh source = result();
  FloatTriMesh target;
  copy_result(result(9), target);
  target.status(target.vertex_handle(1)).set_deleted(true);
  OpenMesh::VPropHandleT<int> own;
  target.add_property(own, "own");
  copy_result(source, target);
  expect_same_connectivity(source, target);
  expect_same_properties(source, target);
  EXPECT_FALSE(target.status(target.vertex_handle(1)).deleted());
  EXPECT_EQ(target.property(own).n_elements(), source.n_vertices());
}

TEST(CopyResult, LeavesAResultCopiedOntoItselfAlone) {
  PolyMesh mesh = result();
  copy_result(mesh, mesh);
  expect_same_properties(result(), mesh);
}

TEST(CopyResult, CanBecomeACage) {
  const PolyMesh source = result();
  FloatTriMesh target;
  copy_result(source, target);
  const Cage cage = cage_from_mesh(target);
  EXPECT_EQ(cage.points.size(), source.n_vertices());
  EXPECT_EQ(cage.faces.size(), source.n_faces());
}

TEST(CopyResult, RefusesQuadsInTriangleMeshes) {
  const PolyMesh source = with_properties(
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  FloatTriMesh triangles;
  EXPECT_EQ(error_of([&] { copy_result(source, triangles); }),
            "invalid input: face 0 of the result has 4 corners; the target holds triangles only");
  DoublePolyMesh polygons;
  copy_result(source, polygons);
  expect_same_connectivity(source, polygons);
}

TEST(CopyResult, RefusesPositionsThatFloatCannotHold) {
  PolyMesh source = result();
  source.point(VertexHandle(2))[1] = 1e300;
  FloatTriMesh target;
  copy_result(result(), target);
  EXPECT_EQ(error_of([&] { copy_result(source, target); }).substr(0, 72),
            "invalid input: vertex 2 of the result: points of the target cannot hold ");
  EXPECT_EQ(target.n_faces(), source.n_faces());
}

TEST(CopyResult, RefusesDeletedElements) {
  PolyMesh source = result();
  source.request_face_status();
  source.status(FaceHandle(5)).set_deleted(true);
  FloatTriMesh target;
  EXPECT_EQ(error_of([&] { copy_result(source, target); }),
            "invalid input: face 5 of the result is deleted; call garbage_collection() first");
}

TEST(CopyResult, NamesPropertiesThatAreMissing) {
  PolyMesh source = result();
  detach(source, keys::edge_contour);
  FloatTriMesh target;
  EXPECT_EQ(error_of([&] { copy_result(source, target); }),
            "missing property: the mesh has no property surf:contour, which the stage "
            "patch_mesh, assemble "
            "makes");
}

}  // namespace
}  // namespace surfmesh
