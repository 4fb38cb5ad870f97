// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/surface_waves.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "cage/meshes.hh"
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

}  // namespace
}  // namespace surfmesh
