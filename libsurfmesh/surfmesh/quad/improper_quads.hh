// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh {

/// Put further quads into patches where the result would not be a proper mesh: where two edges join
/// the same two vertices, or a quad has a vertex twice. This happens where patches are one or two
/// quads wide.
///
/// The two quads at such an edge, or the one quad, become smaller ones inside a ring of quads.
/// `fields` holds the metric of each patch.
///
/// Cost     O(quads at contours), and a surface evaluation for each vertex of a patch that changes
/// Returns  the number of places that were mended
/// Throws   Geometry if a place cannot be mended: at a triangle that is left, or without end
std::size_t mend_improper_quads(std::vector<PatchMesh>& patches, const Model& model,
                                const std::vector<const MetricField*>& fields);

}  // namespace surfmesh
