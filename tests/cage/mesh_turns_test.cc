// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mesh_turns.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "cage/meshes.hh"

namespace surfmesh {
namespace {

TEST(MeshTurns, AreSmallOnASphere) {
  const MeshTurns turns = measure_turns(testing::sphere_mesh(3));
  EXPECT_NEAR(turns.median, 5, 1.5);
  EXPECT_NEAR(turns.length, testing::kSphereEdge, 0.01);
  EXPECT_EQ(turns.noisy_share, 0);
  EXPECT_LT(turns.roughness, 0.01);
  EXPECT_EQ(turns.spikes, 0U);
}

TEST(MeshTurns, GrowWithCoarseFaces) {
  EXPECT_GT(measure_turns(testing::sphere_mesh(2)).median,
            1.8 * measure_turns(testing::sphere_mesh(3)).median);
}

TEST(MeshTurns, SeeNoNoiseBesideSharpEdges) {
  const MeshTurns turns = measure_turns(testing::cylinder_mesh(40));
  EXPECT_LT(turns.noisy_share, 0.1);
  EXPECT_EQ(turns.spikes, 0U);
}

TEST(MeshTurns, SeeNoiseOfAFifthOfTheEdges) {
  const Cage mesh = testing::with_noise(testing::sphere_mesh(3), 0.2 * testing::kSphereEdge);
  EXPECT_GT(measure_turns(mesh).noisy_share, 1.2 * kNoisyShare);
  EXPECT_LT(measure_turns(testing::with_noise(testing::sphere_mesh(3), 0.05 * testing::kSphereEdge))
                .noisy_share,
            kNoisyShare / 2);
}

TEST(MeshTurns, FindAVertexThatStandsOut) {
  for (const double share : {0.3, 0.6, -0.4}) {
    Cage mesh = testing::sphere_mesh(3);
    mesh.points[123] *= 1 + share * testing::kSphereEdge;
    const MeshTurns turns = measure_turns(mesh);
    EXPECT_EQ(turns.spikes, 1U);
    EXPECT_EQ(turns.spike, 123);
    EXPECT_GT(turns.spike_height, 0.15);
  }
}

/// Vertices at the border of a hole are not compared with others.
TEST(MeshTurns, LeaveOutBordersOfHoles) {
  Cage mesh = testing::sphere_mesh(3);
  mesh.points[123] *= 1 + 0.3 * testing::kSphereEdge;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    if (std::find(face.begin(), face.end(), 123) == face.end()) continue;
    mesh.holes = {static_cast<int>(f)};
  }
  ASSERT_EQ(mesh.holes.size(), 1U);
  EXPECT_EQ(measure_turns(mesh).spikes, 0U);
}

TEST(MeshTurns, AreNoneWithoutEdges) {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  cage.faces = {{0, 1, 2}};
  const MeshTurns turns = measure_turns(cage);
  EXPECT_EQ(turns.median, 0);
  EXPECT_EQ(turns.noisy_share, 0);
}

}  // namespace
}  // namespace surfmesh
