// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/quad/boundary_corners.hh"

namespace surfmesh {

struct PlacementReport {
  std::size_t inserted = 0;  ///< inner nodes
  /// True if the run was given up at three times the number of triangles that the metric area asks
  /// for.
  bool is_stopped = false;
  QueryCounts queries;  ///< of the metric field
};

/// Insert the inner nodes of a patch where they are corners of unit squares.
///
/// Each node carries a cross of four directions; at the boundary, the directions that divide the
/// corner evenly into its quads. From node to node, in the order in which they came, a new node is
/// tried at metric length 1 in each direction that is still free. The cross is carried along by the
/// connection of the metric, so that squares stay in rows where sizes change and turn. A place is
/// refused within 0.55 of another node, as the cross there measures it, and within 0.45 of the
/// boundary.
///
/// At the end, elements are renumbered in spatial order, but for the vertices that existed before.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of new vertices
/// Cost     O(n), 4 µs and 8 metric queries per node
/// Throws   Limit if there are more triangles than the context allows; Cancelled
PlacementReport place_square_nodes(DelaunayMesh& delaunay, const MetricField& field,
                                   std::span<const BoundaryCorner> corners,
                                   const RunContext& context);

}  // namespace surfmesh
