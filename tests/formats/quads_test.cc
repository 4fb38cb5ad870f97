// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/example_meshes.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/quad_meshes.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"

/// Meshes of quads alone, in files.
namespace surfmesh {
namespace {

/// A wavy grid in which every cell is a quad.
PolyMesh quads() {
  PolyMesh mesh = wavy_grid(6, 1);
  attach_result_properties(mesh);
  return mesh;
}

class QuadFiles : public ::testing::TestWithParam<std::string> {};

TEST_P(QuadFiles, AreReadWithTheSameFaces) {
  const TestFolder folder;
  const PolyMesh mesh = quads();
  write_mesh(mesh, folder / ("a" + GetParam()));
  const MeshFile read = read_mesh(folder / ("a" + GetParam()));
  testing::expect_valid(read.mesh);
  EXPECT_EQ(mesh_arrays(read.mesh).faces, mesh_arrays(mesh).faces);
  for (const FaceHandle fh : read.mesh.faces()) EXPECT_EQ(read.mesh.valence(fh), 4u);
}

INSTANTIATE_TEST_SUITE_P(Formats, QuadFiles, ::testing::Values(".obj", ".off", ".ply", ".om"),
                         [](const auto& test) { return test.param.substr(1); });

/// The triangles of a quad in an STL file, which knows no quads, fill it.
TEST(QuadFiles, OfStlHaveTwoTrianglesForEachQuad) {
  const TestFolder folder;
  const testing::GridNumbers number(4, 3);
  write_mesh(testing::quad_grid(number), folder / "a.stl");
  const MeshFile read = read_mesh(folder / "a.stl");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_faces(), 24u);
  EXPECT_EQ(read.mesh.n_vertices(), 20u);
  double area = 0;
  for (const FaceHandle fh : read.mesh.faces()) {
    std::vector<Vec3> points;
    for (const VertexHandle vh : read.mesh.fv_range(fh)) {
      points.push_back(to_eigen(read.mesh.point(vh)));
    }
    ASSERT_EQ(points.size(), 3u);
    const double z = 0.5 * (points[1] - points[0]).cross(points[2] - points[0]).z();
    EXPECT_GT(z, 0);
    area += z;
  }
  EXPECT_NEAR(area, 12, 1e-12);
}

}  // namespace
}  // namespace surfmesh
