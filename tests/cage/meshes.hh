// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>

#include "cage/cages.hh"
#include "surfmesh/cage/refine_cage.hh"

namespace surfmesh::testing {

/// The unit sphere as a mesh of 20 · 4^levels triangles.
inline Cage sphere_mesh(int levels) {
  Cage cage = icosahedron();
  for (int k = 0; k < levels; ++k) {
    cage = refine_once(cage, Scheme::Loop).cage;
    for (Vec3& point : cage.points) point.normalize();
  }
  cage.notices.clear();
  return cage;
}

/// Edges of the mesh of a sphere of 1,280 triangles.
inline constexpr double kSphereEdge = 0.15;

/// A cylinder of n faces around, with flat ends, all in triangles.
inline Cage cylinder_mesh(int n) {
  Cage cage = tube(n, n / 4, 1);
  for (Vec3& point : cage.points) point.z() *= 8.0 / n;
  const int top = n * (n / 4);
  const int first = static_cast<int>(cage.points.size());
  cage.points.emplace_back(0, 0, 0);
  cage.points.emplace_back(0, 0, 2);
  cage = halved_quads(cage);
  for (int i = 0; i < n; ++i) {
    cage.faces.push_back({(i + 1) % n, i, first});
    cage.faces.push_back({top + i, top + (i + 1) % n, first + 1});
  }
  return cage;
}

/// A mesh around the origin with its points moved along their rays by up to so much.
inline Cage with_noise(Cage cage, double amplitude) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  for (Vec3& point : cage.points) point += uniform(random) * point.normalized();
  return cage;
}

}  // namespace surfmesh::testing
