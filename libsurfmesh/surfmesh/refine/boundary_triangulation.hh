// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// The triangles between the nodes of a boundary, and the queries they took.
struct BoundaryTriangulation {
  std::unique_ptr<DelaunayMesh> delaunay;
  QueryCounts queries;  ///< of the metric field
};

/// Triangulate the nodes of one patch's loops, with all their segments as edges, and remove what
/// lies outside or in holes.
///
/// This is a constrained Delaunay triangulation in the plane scaled by the mean of the metric's
/// diagonal, followed by swaps by quality in the metric; inserting boundary nodes directly in a
/// strong metric would lose edges. Vertices are the nodes in the order of the loops. Loops may
/// touch in nodes of the same (u,v), each turning there into the sector from which it comes; the
/// triangles of different sectors then have no vertex in common.
///
/// Writes   surf:uv, surf:metric (vertex), surf:constrained (edge)
/// Cost     O(n log n), about 3 µs per node
/// Throws   Geometry if loops cross themselves or each other, touch elsewhere than in nodes or are
///          not finite, naming (u,v), or if they have no interior
/// Source   paper, section 2.1, item 2
BoundaryTriangulation triangulate_boundary(const std::vector<std::vector<Uv>>& loops,
                                           const MetricField& field);

}  // namespace surfmesh
