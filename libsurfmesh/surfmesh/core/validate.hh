// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Counts that do not change under deformation.
struct MeshTopology {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_edges = 0;  ///< edges with one face
  std::size_t split_vertices = 0;  ///< on the boundary more than once: not manifold there
  std::size_t components = 0;      ///< connected by edges; an isolated vertex is one of its own
  long euler = 0;                  ///< vertices − edges + faces
  bool is_closed = false;          ///< there are faces, and no boundary edge

  friend bool operator==(const MeshTopology&, const MeshTopology&) = default;
};

/// Count the elements and components of a mesh without faults.
///
/// Cost     O(edges)
MeshTopology measure_topology(const PolyMesh& mesh);

/// List the broken invariants of the half-edge structure, in plain English; empty for a proper
/// mesh.
///
/// Handles are in range; next and previous undo each other and stay at one face; the halfedges of a
/// face are one cycle of at least three; a vertex reaches all its
/// halfedges by turning around it, and starts at its boundary halfedge if it has one; no edge from
/// a vertex to itself, no two edges between the same vertices; every edge has a face. Lists the
/// first hundred faults of each kind.
///
/// Reads    topology only
/// Cost     O(n log n)
std::vector<std::string> find_faults(const PolyMesh& mesh);

}  // namespace surfmesh
