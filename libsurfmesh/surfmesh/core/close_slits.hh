// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Glue pairs of open edges between the same two vertices, which are both sides of one slit. Edges
/// that more than two faces share end so, if two of these faces are neighbours at both ends.
///
/// Returns  the number of pairs. The mesh loses an edge for each; the last edges take their numbers
/// Pre      `open_edges` have a face on one side, and are in rising order; each vertex has one fan
std::size_t close_slits(PolyMesh& mesh, const std::vector<EdgeHandle>& open_edges);

}  // namespace surfmesh
