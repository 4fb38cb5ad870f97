// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/quad/quad_options.hh"

namespace surfmesh {

/// What the conversion of triangles depends on besides the mesh.
struct FrontalInput {
  const MetricField& field;
  std::span<const std::size_t> loop_sizes;  ///< the nodes of the loops, the first vertices
  QuadFront front = QuadFront::Mixed;
};

struct FrontalReport {
  std::size_t advanced = 0;   ///< quads by side edges and a top edge
  std::size_t merged = 0;     ///< quads by merging triangles
  std::size_t forced = 0;     ///< quads that smoothing had to open
  std::size_t triangles = 0;  ///< left
  QueryCounts queries;        ///< of the metric field
};

/// Convert triangles to quads, from the boundary inwards.
///
/// One loop: take the first edge of the fronts, by level, good side angles and length in the metric
/// at its middle; make a quad there by one of both ways, and smooth its neighbourhood. No quad is
/// made that leaves a region of an odd number of triangles. Where none of both ways leads to a
/// quad, the edge comes again at a later level.
///
/// All quads are strictly convex in (u,v). Vertices of the boundary stay as they are.
///
/// Reads    surf:uv, surf:metric (vertex)
/// Writes   surf:uv, surf:metric of new and moved vertices
/// Cost     O(n log n)
/// Throws   Cancelled
/// Source   paper, section 2.1, item 5
FrontalReport convert_frontal(PolyMesh& mesh, FaceEditor& editor, const FrontalInput& input,
                              const RunContext& context);

}  // namespace surfmesh
