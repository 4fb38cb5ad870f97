// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {

/// Parameters and metric of a vertex.
inline MetricCorner corner(const DelaunayMesh& delaunay, VertexHandle vh) {
  return {delaunay.uv(vh), delaunay.metric(vh)};
}

/// Quality of a triangle of the mesh in the mean metric of its vertices.
double quality(const DelaunayMesh& delaunay, FaceHandle fh);

/// Swap the edges of a list, and those around them, where that raises the lower quality of the two
/// triangles at the edge.
///
/// Each triangle is measured in its own mean metric: with a metric averaged over the four vertices,
/// swaps can cycle. Constrained edges stay. Every swap raises the quality by a minimum step, and
/// the number of swaps is bounded as well.
///
/// Reads    surf:uv, surf:metric, surf:constrained
/// Returns  the number of swaps
/// Cost     about 150 ns per edge examined
/// Throws   Cancelled
std::size_t swap_edges(DelaunayMesh& delaunay, std::vector<EdgeHandle> edges,
                       const RunContext& context = RunContext());

/// The same for all edges of the mesh. Those between two good triangles, which a swap never makes
/// better, are not tried.
///
/// Cost     about 30 ns per triangle, and those edges
std::size_t swap_edges(DelaunayMesh& delaunay, const RunContext& context = RunContext());

}  // namespace surfmesh
