// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Note which vertices of a result are copies of others: those of equal positions on contours of
/// three and more patches, where a half-edge mesh cannot have one vertex for all.
///
/// Reads    surf:contour (edge)
/// Writes   surf:original (vertex), only if there are such contours
/// Cost     O(edges) if there are such contours, else O(contours)
void mark_copies(PolyMesh& mesh, const Model& model);

}  // namespace surfmesh
