// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// The finished mesh of one patch in its domain. Its first vertices are the nodes of the loops, in
/// their order.
struct PatchMesh {
  PatchBoundary boundary;
  std::unique_ptr<DelaunayMesh> delaunay;
  const Surface* surface = nullptr;
  const MetricField* field = nullptr;
  /// Positions of the vertices, and normals p_u × p_v of any length; by evaluate_vertices.
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
};

/// Evaluate the surface at the vertices that have no position yet.
void evaluate_vertices(PatchMesh& patch);

/// Split an inner edge at its middle in (u,v). The new node gets its metric.
///
/// Returns  false, and does nothing, if the middle as rounded does not lie strictly inside the two
///          triangles
bool split_chord(PatchMesh& patch, EdgeHandle eh);

/// The vertex of the result for each node of the loops, or -1 for nodes of the patch's own.
std::vector<int> boundary_vertices(const PatchBoundary& boundary);

/// Split chords that would make the result improper: edges from a vertex to itself, and edges
/// between two vertices that another edge joins, also across patches.
///
/// Chords between boundary nodes, and from them to inner nodes (which see both sides of a seam in a
/// coarse mesh), are split in their middle until none offends.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of new vertices
/// Returns  the number of nodes
/// Cost     O(boundary nodes) per round, rarely more than two rounds
/// Throws   Geometry if rounds do not end
std::size_t split_improper_chords(std::vector<PatchMesh>& patches);

}  // namespace surfmesh
