// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh {

/// Vertices of a mesh that follow each other.
struct VertexRange {
  int first = 0;
  int end = 0;
};

/// What to tell of a result, and what later stages must know of its vertices.
struct AssembleReport {
  Notices notices;  ///< what the mesh is other than the model
  VertexRange
      between_tiles;  ///< the vertices on cuts, and on rings around the poles of cut patches
};

/// Join the meshes of all patches into one, in a mesh that has no elements yet. A patch may have
/// several meshes, in a row, with numbers for the nodes that they share (NodeNumbers::add).
///
/// Vertices on contours are identified by the numbers of their nodes, never by distance. Several
/// vertices of a domain may become one (seams, poles), and a triangle that collapses is left out.
/// Neighbouring patches are oriented alike. Where a half-edge mesh cannot represent the model
/// (edges of three or more patches, a Möbius band), it is cut along the contour, with equal
/// positions on both sides and a warning. Where patches meet only in a vertex, each fan gets a
/// vertex of its own, with a warning that says where.
///
/// Writes   point(); surf:patch (face), surf:contour (edge), surf:uv and surf:metric (halfedge, at
///          its tip)
/// Each of the meshes is freed as soon as it is copied.
///
/// Cost     O(n), shared by piece; for m sides at contours and between pieces O(m log m) more,
///          which is not shared
/// Pre      split_improper_chords has been called
/// Throws   Cancelled
AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, std::vector<PatchMesh> patches,
                        const RunContext& context = RunContext());

}  // namespace surfmesh
