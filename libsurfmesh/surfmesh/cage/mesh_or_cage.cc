// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mesh_or_cage.hh"

namespace surfmesh {
namespace {

/// What people model by hand has up to some hundred triangles, and some thousand quads: cages of
/// characters in films. Meshes of 2,000 triangles of a cow, a pawn, a car, a torus and a sphere
/// turn by 4 to 12 degrees at half of their edges, their cages by 14 to 56.
constexpr std::size_t kManyTriangles = 1000;
constexpr std::size_t kManyQuads = 2500;
constexpr double kSmoothTriangles = 20;
constexpr double kSmoothQuads = 8;
/// Loose triangles, or faces that are there twice, are no surface.
constexpr double kLeastPairedShare = 0.5;

}  // namespace

bool has_tags(const Cage& cage) {
  return !cage.creases.empty() || !cage.corners.empty() || !cage.holes.empty() ||
         cage.boundary != BoundaryRule::EdgeOnly || cage.is_chaikin || cage.is_smooth_triangles;
}

bool is_fine(const Cage& cage, Scheme scheme) {
  return cage.faces.size() >= (scheme == Scheme::Loop ? kManyTriangles : kManyQuads);
}

double smooth_turn(Scheme scheme) {
  return scheme == Scheme::Loop ? kSmoothTriangles : kSmoothQuads;
}

bool is_mesh_of_surface(const Cage& cage, Scheme scheme, const MeshTurns& turns) {
  if (scheme == Scheme::Bilinear || has_tags(cage) || !is_fine(cage, scheme)) return false;
  return turns.paired_share > kLeastPairedShare && turns.median < smooth_turn(scheme);
}

}  // namespace surfmesh
