// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mesh_or_cage.hh"

#include <gtest/gtest.h>

#include <filesystem>

#include "cage/meshes.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

bool is_mesh(const Cage& cage) {
  return is_mesh_of_surface(cage, resolve_scheme(cage, Scheme::Auto), measure_turns(cage));
}

TEST(MeshOrCage, TakesFineSmoothTrianglesForAMesh) {
  EXPECT_TRUE(is_mesh(testing::sphere_mesh(3)));
  EXPECT_TRUE(is_mesh(testing::cylinder_mesh(48)));
}

TEST(MeshOrCage, TakesQuadsForAMeshIfTheyAreMany) {
  EXPECT_FALSE(is_mesh(testing::torus(60, 30)));
  EXPECT_TRUE(is_mesh(testing::torus(100, 50)));
}

TEST(MeshOrCage, TakesFewOrRoughFacesForACage) {
  EXPECT_FALSE(is_mesh(testing::sphere_mesh(2)));
  EXPECT_FALSE(is_mesh(testing::with_noise(testing::sphere_mesh(3), 0.3)));
}

TEST(MeshOrCage, TakesLooseTrianglesForACage) {
  Cage soup;
  const Cage mesh = testing::sphere_mesh(3);
  for (const std::vector<int>& face : mesh.faces) {
    const int first = static_cast<int>(soup.points.size());
    for (const int v : face) soup.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(measure_turns(soup).paired_share, 0);
  EXPECT_FALSE(is_mesh(soup));
}

TEST(MeshOrCage, TakesDoubledFacesForACage) {
  Cage mesh = testing::sphere_mesh(3);
  const std::vector<std::vector<int>> faces = mesh.faces;
  mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
  EXPECT_EQ(measure_turns(mesh).paired_share, 0);
  EXPECT_FALSE(is_mesh(mesh));
}

/// Where few edges have three faces the rest is a mesh as well.
TEST(MeshOrCage, TakesAMeshWithAFinForAMesh) {
  Cage mesh = testing::sphere_mesh(3);
  mesh.points.emplace_back(0, 0, 2);
  const std::vector<int> face = mesh.faces[0];
  mesh.faces.push_back({face[0], face[1], static_cast<int>(mesh.points.size()) - 1});
  const MeshTurns turns = measure_turns(mesh);
  EXPECT_LT(turns.paired_share, 1);
  EXPECT_GT(turns.paired_share, 0.99);
  EXPECT_TRUE(is_mesh(mesh));
}

TEST(MeshOrCage, TakesWhatHasTagsForACage) {
  Cage cage = testing::sphere_mesh(3);
  cage.corners = {{0, 2}};
  EXPECT_FALSE(is_mesh(cage));
  cage.corners.clear();
  cage.boundary = BoundaryRule::EdgeAndCorner;
  EXPECT_FALSE(is_mesh(cage));
}

TEST(MeshOrCage, TakesTheCagesOfOthersForCages) {
  int count = 0;
  for (const char* folder : {SURFMESH_SOURCE_DIR "/models", SURFMESH_SHARED_DIR "/models",
                             SURFMESH_SHARED_DIR "/models/opensubdiv"}) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!has_cage_ending(entry.path())) continue;
      EXPECT_FALSE(is_mesh(read_cage(entry.path()))) << entry.path();
      ++count;
    }
  }
  EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace surfmesh
