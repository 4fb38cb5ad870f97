// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/mesh_elements.hh"

#include <gtest/gtest.h>

#include "formats/named_example.hh"
#include "support/errors.hh"
#include "support/meshes.hh"
#include "surfmesh/formats/smooth_normals.hh"

namespace surfmesh {
namespace {

TEST(MeshElements, AreInTheOrderOfPatches) {
  PolyMesh mesh = testing::mesh_of(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {3, 0, 0}},
      {{0, 1, 2}, {0, 2, 3}, {1, 4, 5, 2}, {4, 6, 5}});
  const auto patch = attach(mesh, keys::face_patch, -1);
  mesh.property(patch).data_vector() = {7, -1, 2, 2};
  const MeshElements elements = mesh_elements(mesh, ".msh");
  EXPECT_EQ(elements.triangles, (std::vector<std::array<int, 3>>{{4, 6, 5}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(elements.quads, (std::vector<std::array<int, 4>>{{1, 4, 5, 2}}));
  ASSERT_EQ(elements.patches.size(), 3U);
  EXPECT_EQ(elements.patches[0].patch, 2);
  EXPECT_EQ(elements.patches[0].size(), 2U);
  EXPECT_EQ(elements.patches[1].patch, 7);
  EXPECT_EQ(elements.patches[1].first(), 2U);
  EXPECT_EQ(elements.patches[2].patch, -1);
  EXPECT_EQ(elements.patches[2].first(), 3U);
}

TEST(MeshElements, OfMoreCornersAreSplit) {
  const PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4}});
  EXPECT_EQ(mesh_elements(mesh, ".msh").triangles,
            (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(MeshElements, HaveContoursOnce) {
  const MeshElements elements = mesh_elements(named_example(0), ".msh");
  ASSERT_EQ(elements.contours.size(), 2U);
  EXPECT_EQ(elements.contours[0].segments.size(), 4U);
  EXPECT_EQ(elements.contours[1].segments.size(), 16U);
  EXPECT_EQ(nodes_of(elements, elements.contours[0]), (std::vector<int>{10, 11, 12, 13, 14}));
  const std::vector<char> ends = contour_ends(elements);
  for (std::size_t v = 0; v < ends.size(); ++v) EXPECT_EQ(ends[v] != 0, v == 10 || v == 14) << v;
  for (const ContourSegment& segment : elements.segments) EXPECT_TRUE(segment.is_smooth);
}

/// Three faces at an edge: one has vertices of its own.
TEST(MeshElements, AreWithoutCopiesOfVertices) {
  PolyMesh mesh = testing::mesh_of(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
      {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}});
  const auto original = attach(mesh, keys::vertex_original);
  mesh.property(original).data_vector() = {0, 1, 2, 3, 0, 1, 6};
  const auto contour = attach(mesh, keys::edge_contour, -1);
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const bool is_on_axis = mesh.point(mesh.from_vertex_handle(heh)).sqrnorm() +
                                mesh.point(mesh.to_vertex_handle(heh)).sqrnorm() ==
                            1;
    if (is_on_axis && std::abs(mesh.calc_edge_vector(heh)[0]) == 1) mesh.property(contour, eh) = 3;
  }
  const MeshElements elements = mesh_elements(mesh, ".msh");
  EXPECT_EQ(elements.points.size(), 5U);
  EXPECT_EQ(elements.triangles.back(), (std::array<int, 3>{0, 1, 4}));
  ASSERT_EQ(elements.segments.size(), 1U);
  EXPECT_EQ(elements.segments[0].contour, 3);
}

TEST(MeshElements, HavePatchesAndContoursThatAFileCanNumber) {
  PolyMesh mesh = testing::octahedron();
  const auto patch = attach(mesh, keys::face_patch, 0);
  mesh.property(patch, FaceHandle(3)) = 10'000'001;
  EXPECT_EQ(error_of([&] { mesh_elements(mesh, ".bdf"); }),
            "invalid input: a face is of patch 10000001, but .bdf files hold them up to 10000000");
}

TEST(SmoothNormals, AreTheMeansOfAClosedMesh) {
  const PolyMesh mesh = testing::octahedron();
  const auto normals = smooth_normals(mesh);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const Vec3 outwards = to_eigen(mesh.point(mesh.to_vertex_handle(heh))).normalized();
    EXPECT_NEAR((normals[index(heh)] - outwards).norm(), 0, 1e-12);
  }
}

TEST(SmoothNormals, BreakAtContours) {
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  const auto contour = attach(mesh, keys::edge_contour, -1);
  const auto normal_of = [&](int face) {
    return smooth_normals(mesh)[index(mesh.halfedge_handle(FaceHandle(face)))];
  };
  const Vec3 mean = Vec3(0, 1, 1).normalized();
  for (const HalfedgeHandle heh : mesh.fh_range(FaceHandle(0))) {
    if (mesh.to_vertex_handle(heh).idx() > 1) continue;
    EXPECT_NEAR((smooth_normals(mesh)[index(heh)] - mean).norm(), 0, 1e-12);
  }
  for (const EdgeHandle eh : mesh.edges()) mesh.property(contour, eh) = 0;
  EXPECT_NEAR((normal_of(0) - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR((normal_of(1) - Vec3::UnitY()).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace surfmesh
