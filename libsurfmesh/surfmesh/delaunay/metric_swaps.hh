// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

inline MetricCorner corner(const DelaunayMesh& delaunay, VertexHandle vh) {
  return {delaunay.uv(vh), delaunay.metric(vh)};
}

/// Quality of a triangle of the mesh in the mean metric of its vertices.
double quality(const DelaunayMesh& delaunay, FaceHandle fh);

/// Swap edges of a list, and those around them, where that raises the lesser quality of the two
/// triangles at the edge.
///
/// Each triangle is measured in its own mean metric: with a metric averaged over the four vertices
/// swaps can cycle. Constrained edges stay. Every swap raises the quality by a least step, and the
/// number of swaps is bounded, too.
///
/// Reads    surf:uv, surf:metric, surf:constrained
/// Returns  the number of swaps
/// Cost     about 150 ns an edge looked at
std::size_t swap_edges(DelaunayMesh& delaunay, std::vector<EdgeHandle> edges);

/// The same for all edges of the mesh.
std::size_t swap_edges(DelaunayMesh& delaunay);

}  // namespace surfmesh
