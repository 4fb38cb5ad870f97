// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/control/metric_field.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"

namespace surfmesh {

struct ImproveOptions {
  /// Smoothing sweeps over all inner vertices; the first brings 75 % of the gain, the second 18 %.
  int sweeps = 2;
  /// Passes over the triangles of low quality at the end; 0 is off.
  int repairs = 3;
  Observer* observer = nullptr;  ///< asked whether to go on; not owned, null for none
};

void check(const ImproveOptions& options);

struct ImproveReport {
  std::size_t moved = 0;    ///< vertex moves accepted
  std::size_t swapped = 0;  ///< edges
  QueryCounts queries;  ///< of the metric field

  friend bool operator==(const ImproveReport&, const ImproveReport&) = default;
};

/// Move inner vertices to where their edges are of unit length, swap edges by quality, and repair
/// what is bad after that.
///
/// A move is accepted only if no triangle around the vertex is inverted and the worst of them does
/// not become worse, or stays good. Boundary vertices stay.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of moved vertices
/// Cost     about 0.1 µs a triangle and half a metric query a sweep
/// Source   paper, section 2.1, item 4
ImproveReport improve(DelaunayMesh& delaunay, const MetricField& field,
                      const ImproveOptions& options = {});

}  // namespace surfmesh
