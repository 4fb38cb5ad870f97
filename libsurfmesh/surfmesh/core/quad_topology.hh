// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {

/// True if there is a face at a halfedge, and it is a quad. OpenMesh's own valence() is not
/// inlined.
inline bool is_at_quad(const PolyMesh& mesh, HalfedgeHandle heh) {
  if (!mesh.face_handle(heh).is_valid()) return false;
  const HalfedgeHandle opposite = mesh.next_halfedge_handle(mesh.next_halfedge_handle(heh));
  return mesh.next_halfedge_handle(mesh.next_halfedge_handle(opposite)) == heh;
}

/// True if a face is a quad.
/// Cost     O(faces), shared
inline bool has_quads(const PolyMesh& mesh) {
  std::atomic<bool> is_found = false;
  share_ranges(mesh.n_faces(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end && !is_found; ++f) {
      if (is_at_quad(mesh, mesh.halfedge_handle(FaceHandle(static_cast<int>(f))))) is_found = true;
    }
  });
  return is_found;
}

/// The sides of the quad of a halfedge, from that on.
/// Pre      is_at_quad
inline std::array<HalfedgeHandle, 4> quad_sides(const PolyMesh& mesh, HalfedgeHandle heh) {
  std::array<HalfedgeHandle, 4> sides;
  for (HalfedgeHandle& side : sides) {
    side = heh;
    heh = mesh.next_halfedge_handle(heh);
  }
  return sides;
}

/// The vertices of the quad of a halfedge, from its origin on.
/// Pre      is_at_quad
inline std::array<VertexHandle, 4> quad_vertices(const PolyMesh& mesh, HalfedgeHandle heh) {
  std::array<VertexHandle, 4> vertices;
  for (VertexHandle& vh : vertices) {
    vh = mesh.from_vertex_handle(heh);
    heh = mesh.next_halfedge_handle(heh);
  }
  return vertices;
}

}  // namespace surfmesh
