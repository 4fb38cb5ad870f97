// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh.hh"
#include "surfmesh/quality/moments.hh"

namespace surfmesh::detail {

/// Lengths of edges in space, model units; all 0 without edges.
struct SpaceLengths {
  Moments moments;
  double min = 0, max = 0;
};

/// Measure every edge of a mesh.
///
/// Cost     O(edges), shared among threads
SpaceLengths measure_lengths(const PolyMesh& mesh);

}  // namespace surfmesh::detail
