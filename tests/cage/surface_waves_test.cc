// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/surface_waves.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cage/meshes.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/sharp_features.hh"

namespace surfmesh {
namespace {

SurfaceWaves waves_of(const Cage& mesh) {
  return measure_waves(mesh, interpolating_cage(mesh).cage, resolve_scheme(mesh, Scheme::Auto));
}

TEST(SurfaceWaves, AreNoneOnSmoothMeshes) {
  for (const Cage& mesh : {testing::sphere_mesh(2), testing::torus(30, 20)}) {
    const SurfaceWaves waves = waves_of(mesh);
    EXPECT_EQ(waves.edges, mesh.faces.size() * mesh.faces[0].size() / 2);
    EXPECT_EQ(waves.waves, 0U);
    EXPECT_EQ(waves.greatest, 0);
  }
}

TEST(SurfaceWaves, AreBesideSharpEdgesWithoutATag) {
  Cage mesh = testing::cylinder_mesh(40);
  const SurfaceWaves waves = waves_of(mesh);
  EXPECT_GT(waves.waves, 30U);
  EXPECT_GT(waves.greatest, 6);
  const double z = waves.point.z();
  EXPECT_LT(std::min(std::abs(z), std::abs(z - 2)), 0.5);
  tag_features({}, mesh);
  EXPECT_EQ(waves_of(mesh).waves, 0U);
}

/// What is left of semi-sharp tags after a step is not in the limit normals.
TEST(SurfaceWaves, AreNoFoldsBesideSemiSharpCreases) {
  Cage mesh = testing::cylinder_mesh(40);
  add_creases(60, mesh);
  for (Cage::Crease& crease : mesh.creases) crease.sharpness = 3.5;
  const SurfaceWaves waves = waves_of(mesh);
  EXPECT_TRUE(waves.folded_faces.empty());
  EXPECT_EQ(waves.waves, 0U);
  EXPECT_GT(waves.edges, 100U);
  EXPECT_LT(waves.edges, mesh.faces.size() * 3 / 2 - mesh.creases.size());
}

TEST(SurfaceWaves, LeaveOutHoles) {
  Cage mesh = testing::sphere_mesh(2);
  Cage folded = mesh;
  folded.points[40] *= -1;
  std::vector<int> folds = measure_waves(mesh, folded, Scheme::Loop).folded_faces;
  ASSERT_FALSE(folds.empty());
  mesh.holes = folded.holes = folds;
  EXPECT_TRUE(measure_waves(mesh, folded, Scheme::Loop).folded_faces.empty());
}

TEST(SurfaceWaves, FindsFolds) {
  Cage mesh = testing::sphere_mesh(2);
  EXPECT_TRUE(measure_waves(mesh, mesh, Scheme::Loop).folded_faces.empty());
  Cage folded = mesh;
  folded.points[40] *= -1;  // through the sphere to its other side
  const SurfaceWaves waves = measure_waves(mesh, folded, Scheme::Loop);
  ASSERT_FALSE(waves.folded_faces.empty());
  EXPECT_TRUE(std::is_sorted(waves.folded_faces.begin(), waves.folded_faces.end()));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    if (std::find(face.begin(), face.end(), 40) == face.end()) continue;
    EXPECT_TRUE(std::binary_search(waves.folded_faces.begin(), waves.folded_faces.end(),
                                   static_cast<int>(f)))
        << "face " << f;
  }
}

}  // namespace
}  // namespace surfmesh
