// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Where a new node goes.
enum class Placement {
  Frontal,      ///< where it makes unit edges with the shortest side at the front
  Circumcentre  ///< at the metric circumcentre of the worst triangle, as in the paper
};

/// How a new node is connected.
enum class Kernel { Cavity, Swap };

struct RefineOptions {
  Placement placement = Placement::Frontal;
  Kernel kernel = Kernel::Cavity;
};

void check(const RefineOptions& options);

struct RefineReport {
  std::size_t inserted = 0;  ///< inner nodes
  std::size_t refused = 0;   ///< triangles left larger than wanted, for no place was good
  /// True if the run was given up at three times the count of triangles that the metric area asks
  /// for: the metric turns faster than elements can follow.
  bool is_stopped = false;
  QueryCounts queries;  ///< of the metric field

  friend bool operator==(const RefineReport&, const RefineReport&) = default;
};

/// Insert inner nodes until every triangle is small enough in the metric or cannot be bettered.
///
/// One loop: take the worst triangle of the front, ask the placement for a point, insert it if it
/// keeps its distance from nodes and boundary, else try the circumcentre if the metric there
/// conforms with the triangle's, else leave the triangle as it is. A run that makes three times as
/// many triangles as the metric area of the mesh asks for is given up.
///
/// In the end elements are renumbered in spatial order, but for vertices that were there before.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of new vertices
/// Cost     O(n) queue, 0.6 µs a triangle, at a million 1 µs, and two metric queries a node (one
///          with Circumcentre)
/// Throws   Limit if there are more triangles than the context allows; Cancelled
/// Source   paper, section 2.1, item 3; frontal placement: Rebay, Efficient unstructured mesh
///          generation by means of Delaunay triangulation and Bowyer-Watson algorithm (1993)
RefineReport refine(DelaunayMesh& delaunay, const MetricField& field,
                    const RefineOptions& options = {}, const RunContext& context = RunContext());

}  // namespace surfmesh
