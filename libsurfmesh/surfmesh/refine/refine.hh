// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Where a new node goes.
enum class Placement {
  Frontal,      ///< where it has unit edges to the ends of the shortest side at the front
  Circumcentre  ///< at the metric circumcentre of the worst triangle, as in the paper
};

/// How a new node is connected to the mesh.
enum class Kernel { Cavity, Swap };

/// Where new nodes go, and how they are connected.
struct RefineOptions {
  Placement placement = Placement::Frontal;
  Kernel kernel = Kernel::Cavity;
  /// With Circumcentre: greatest difference between the metrics at a circumcentre and of its
  /// triangle, as the logarithm of a ratio of lengths, for which the circumcentre is inserted. 0:
  /// it is inserted if it lies in the circle of the triangle in the metric at the circumcentre,
  /// too.
  double conformity = 0;
};

/// Throws   InvalidOption, naming the option, its value and its range
void check(const RefineOptions& options);

/// What has become of the triangles that were too large.
struct RefineCounts {
  std::size_t inserted = 0;      ///< inner nodes
  std::size_t refused = 0;       ///< triangles left too large because no point was good
  std::size_t unconforming = 0;  ///< circumcentres given up because the metric there differs

  RefineCounts& operator+=(const RefineCounts& other);
  friend bool operator==(const RefineCounts&, const RefineCounts&) = default;
};

/// What refine inserted, and whether it came to its end.
struct RefineReport {
  RefineCounts counts;
  /// True if the run was given up at three times the number of triangles that the metric area asks
  /// for, and twice that of the boundary alone: the metric changes direction faster than elements
  /// can follow.
  bool is_stopped = false;
  QueryCounts queries;  ///< of the metric field

  friend bool operator==(const RefineReport&, const RefineReport&) = default;
};

/// Insert inner nodes until every triangle is small enough in the metric or cannot be improved.
///
/// One loop: take the worst triangle of the front and compute a point by the placement. Insert it
/// if it is far enough from nodes and boundary. Otherwise try the circumcentre, if the metric there
/// conforms with that of the triangle, or else leave the triangle as it is. The run is given up
/// when it has made three times as many triangles as the metric area of the mesh asks for, and
/// twice as many as the boundary makes alone.
///
/// The context counts the triangles as unfinished; they stay so at the end.
///
/// At the end, elements are renumbered in spatial order, except vertices that existed before.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of new vertices
/// Cost     O(n) queue, 0.6 µs per triangle (1 µs at a million), and two metric queries per node
///          (one with Circumcentre)
/// Throws   InvalidOption; Limit if there are more triangles than the context allows; Cancelled
/// Source   paper, section 2.1, item 3; frontal placement: Rebay, Efficient unstructured mesh
///          generation by means of Delaunay triangulation and Bowyer-Watson algorithm (1993)
RefineReport refine(DelaunayMesh& delaunay, const MetricField& field,
                    const RefineOptions& options = {}, const RunContext& context = RunContext());

}  // namespace surfmesh
