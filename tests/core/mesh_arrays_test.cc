// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/mesh_arrays.hh"

#include <gtest/gtest.h>

#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// A square of two triangles, with a value of its own at each corner and edge.
PolyMesh example() {
  PolyMesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  const auto c = mesh.add_vertex({1, 1, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(std::vector{a, b, c});
  mesh.add_face(std::vector{a, c, d});
  const auto patch = attach(mesh, keys::face_patch, 7);
  mesh.property(patch, FaceHandle(1)) = 3;
  const auto contour = attach(mesh, keys::edge_contour, -1);
  for (const EdgeHandle eh : mesh.edges()) {
    if (mesh.is_boundary(eh)) mesh.property(contour, eh) = 10 + eh.idx();
  }
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  const auto normal = attach(mesh, keys::corner_normal);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    mesh.property(uv, heh) = {1.0 * heh.idx(), 0};
    mesh.property(metric, heh) = {1.0 * heh.idx(), 0, 1};
    mesh.property(normal, heh) = {1.0 * heh.idx(), 0, 1};
  }
  return mesh;
}

/// The halfedge of a face between two vertices.
HalfedgeHandle side(const PolyMesh& mesh, int from, int to) {
  return mesh.find_halfedge(VertexHandle(from), VertexHandle(to));
}

TEST(MeshArrays, HoldPointsFacesAndPatches) {
  const MeshArrays arrays = mesh_arrays(example(), {{"p"}, {}});
  EXPECT_EQ(arrays.points.size(), 4u);
  EXPECT_EQ(arrays.points[2], Vec3(1, 1, 0));
  EXPECT_EQ(arrays.faces.size(), 2u);
  EXPECT_EQ(arrays.faces.offsets()[1], 3u);
  EXPECT_EQ(arrays.faces.vertices().size(), 6u);
  EXPECT_EQ(arrays.patches, (std::vector<int>{7, 3}));
  EXPECT_EQ(arrays.names.patches, std::vector<std::string>{"p"});
}

TEST(MeshArrays, GiveEachCornerTheSideAfterItAndTheValuesAtIt) {
  const PolyMesh mesh = example();
  const MeshArrays arrays = mesh_arrays(mesh);
  const auto contour = require(mesh, keys::edge_contour);
  ASSERT_EQ(arrays.contours.size(), 6u);
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    const auto face = arrays.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = arrays.faces.first_corner(f) + k;
      const HalfedgeHandle before = side(mesh, face[(k + 2) % 3], face[k]);
      const HalfedgeHandle after = side(mesh, face[k], face[(k + 1) % 3]);
      EXPECT_EQ(arrays.contours[corner], mesh.property(contour, mesh.edge_handle(after)));
      EXPECT_EQ(arrays.uvs[corner].u, before.idx());
      EXPECT_EQ(arrays.metrics[corner].m11, before.idx());
      EXPECT_EQ(arrays.normals[corner].x, before.idx());
    }
  }
}

TEST(MeshArrays, LeaveOutWhatTheMeshDoesNotHaveOrNobodyAsksFor) {
  const MeshArrays faces = mesh_arrays(example(), {}, ArrayParts::Faces);
  EXPECT_EQ(faces.patches.size(), 2u);
  EXPECT_TRUE(faces.contours.empty() && faces.uvs.empty() && faces.metrics.empty() &&
              faces.normals.empty());
  PolyMesh bare;
  bare.add_vertex({0, 0, 0});
  const MeshArrays arrays = mesh_arrays(bare);
  EXPECT_EQ(arrays.points.size(), 1u);
  EXPECT_TRUE(arrays.patches.empty() && arrays.contours.empty() && arrays.uvs.empty());
}

TEST(MeshNames, PutGroupsInTheOrderOfTheirPatches) {
  std::vector<Group> groups = {{"late", {3, 2, 3}}, {"empty", {}}, {"b", {0}}, {"a", {1, 0}}};
  put_in_order(groups);
  const std::vector<Group> wanted = {{"b", {0}}, {"a", {0, 1}}, {"late", {2, 3}}};
  EXPECT_EQ(groups, wanted);
}

TEST(MeshNames, TellTheGroupsOfEachPatch) {
  const MeshNames names = {{}, {{"a", {0, 2}}, {"b", {2, 9}}}};
  const std::vector<std::vector<int>> wanted = {{0}, {}, {0, 1}};
  EXPECT_EQ(groups_by_patch(names, 3), wanted);
}

}  // namespace
}  // namespace surfmesh
