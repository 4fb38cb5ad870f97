// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/quad/frontal.hh"

namespace surfmesh {

struct QuadReport {
  std::size_t triangles = 0;  ///< left, because the boundary has an odd number of segments
  bool is_given_up = false;   ///< see PlacementReport::is_stopped
  std::size_t tried = 0;      ///< changes of connectivity
  std::size_t changed = 0;    ///< of these, kept
  QueryCounts queries;        ///< of the metric field
};

/// The quads of a patch.
struct PatchQuads {
  std::unique_ptr<PolyMesh> mesh;
  QuadReport report;
};

/// Fill the triangulated boundary of a patch with quads that follow the metric.
///
/// Inner nodes are placed for right-angled triangles, which are merged in pairs; triangles that are
/// left walk to each other. Then the quads are smoothed, cleaned, and smoothed again, the worst
/// corners last. Vertices of the boundary stay as they are.
///
/// `loop_sizes` are the nodes of the loops, which are the vertices of the mesh.
///
/// Reads    surf:uv, surf:metric (vertex), surf:constrained (edge)
/// Writes   surf:uv, surf:metric of new vertices; surf:constrained goes
/// Cost     O(n log n), 10 µs per quad where sizes change slowly, 30 µs where the metric is
/// strongly
///          curved
/// Throws   Limit if there are more triangles than the context allows; Cancelled
PatchQuads make_quads(std::unique_ptr<DelaunayMesh> boundary, const MetricField& field,
                      std::span<const std::size_t> loop_sizes, const RunContext& context);

/// Convert the triangles of a patch to quads by the frontal method, then smooth and clean them as
/// make_quads() does.
///
/// Reads    surf:uv, surf:metric (vertex)
/// Writes   surf:uv, surf:metric of moved and new vertices
/// Cost     O(n log n), about 30 µs per quad
/// Throws   Cancelled
PatchQuads convert_to_quads(std::unique_ptr<DelaunayMesh> triangles, const FrontalInput& input,
                            const RunContext& context);

}  // namespace surfmesh
