// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh {

struct AssembleReport {
  std::vector<std::string> warnings;
};

/// Join the meshes of all patches to one, in a mesh without elements.
///
/// Vertices on contours are the same by the numbers of their nodes, never by distance; several
/// vertices of a domain may become one (seams, poles), and a triangle that collapses is left out.
/// Neighbouring patches are oriented alike. Where a half-edge mesh cannot hold what the model asks
/// for (edges of three and more patches, a Möbius band), the mesh is cut along the contour, with
/// equal positions on both sides and a warning. Where patches meet in a vertex only, each fan gets
/// one of its own, with a warning that names the place.
///
/// Writes   point(); surf:patch (face), surf:contour (edge), surf:uv and surf:metric (halfedge, at
///          its tip)
/// Cost     O(n); O(n log n) for the sides at contours
/// Pre      split_improper_chords and evaluate_vertices have been called
AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, const std::vector<PatchMesh>& patches);

}  // namespace surfmesh
