// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Whether elements may cross contours.
struct AcrossOptions {
  bool is_on = true;  ///< elements cross contours that merely divide a smooth surface
};

/// What improve_across looked at.
struct AcrossReport {
  std::size_t faces = 0;  ///< that might change
  QueryCounts queries;    ///< of the metric fields
};

/// Improve a result across the contours that merely divide a smooth surface, as if these were not
/// there: triangles near them by the criteria of improve(), quads by those of make_quads().
///
/// Vertices on such contours move freely over the surface. A face that lies on several patches
/// becomes one of a single patch: surf:beyond marks its corners beyond the domain of that, whose
/// (u,v) go on as FaceParameters tells. What does not change: creases, borders, contours with a
/// name or between groups, faces around poles and across which the surface turns sharply, and the
/// topology.
///
/// Quads at the cuts between tiles, whose vertices these are, are improved in the same way.
///
/// `fields` holds the metric of each patch. The result does not depend on the number of threads.
/// Reads    surf:patch (face), surf:contour (edge), surf:uv, surf:metric (halfedge)
/// Writes   all of them, surf:beyond (halfedge), and the elements; edges of dissolved contours have
///          -1 in surf:contour, but where faces meet at more than 60°
/// Cost     3 µs per triangle near such contours, 25 µs per quad of their patches, 20 ns for each
///          other face, shared by piece
/// Throws   Cancelled
AcrossReport improve_across(PolyMesh& result, const Model& model,
                            const std::vector<const MetricField*>& fields,
                            const RunContext& context = RunContext(),
                            const VertexRange& between_tiles = {});

}  // namespace surfmesh
