// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/assemble/patch_mesh.hh"

namespace surfmesh::detail {

/// Swap inner edges where that brings the two triangles nearer to the surface: the metric often does
/// not care which diagonal of a quadrilateral is an edge, but only one follows the surface.
///
/// Edges whose triangles have less than half of the sag that is asked for are left alone. No swap
/// makes a triangle turned, or a shape below 0.4 worse.
/// Returns  the number of swaps
/// Cost     three surface evaluations an edge, as many again where the sag is large
/// Pre      evaluate_vertices has been called
std::size_t swap_for_sag(PatchMesh& patch, double asked);

}  // namespace surfmesh::detail
