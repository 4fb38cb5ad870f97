// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/patch_mesh/triangulated_patch.hh"

namespace surfmesh {

/// The finished mesh of one patch, as it is handed to assembly: faces of three or four corners in
/// the patch's domain. Its first vertices are the nodes of the loops, in their order.
///
/// The mesh has surf:uv, surf:metric (vertex) and surf:contour (edge); point() is the position in
/// space.
struct PatchMesh {
  PatchBoundary boundary;
  std::unique_ptr<PolyMesh> mesh;

  std::size_t patch() const { return static_cast<std::size_t>(boundary.patch); }
};

/// Take the triangles of a patch as its finished mesh.
///
/// Writes   point(); surf:contour (edge), -1 inside the patch and on rings around poles
/// Cost     O(vertices); the mesh itself is moved
PatchMesh finish_patch(TriangulatedPatch patch);

/// Take faces in the domain of a patch as its finished mesh. The first vertices are the nodes of
/// the loops.
///
/// Reads    surf:uv (vertex)
/// Writes   point(); surf:contour (edge)
/// Cost     a surface evaluation per vertex
PatchMesh finish_patch(PatchBoundary boundary, std::unique_ptr<PolyMesh> mesh,
                       const Surface& surface);

/// Go on with the triangles of a finished patch.
/// Cost     a surface evaluation per vertex
/// Pre      all faces are triangles
TriangulatedPatch reopen_patch(PatchMesh patch, const Surface& surface, const MetricField& field);

/// The vertex of the result for each node of the loops, or -1 for nodes of the patch's own.
std::vector<int> boundary_vertices(const PatchBoundary& boundary);

}  // namespace surfmesh
