// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh::detail {

/// Put smaller quads into those that are farther from their surface than a sag, and smooth, until
/// none is or nothing helps.
///
/// A quad counts as the two triangles on either side of a diagonal, whichever of the two is worse:
/// what reads the mesh may split it along any. A smaller quad and a ring of four take its place;
/// smoothing spreads the new vertices, so that the quads around become smaller, too.
///
/// The first `fixed` vertices are those of the boundary, which stay.
/// Reads    surf:uv, surf:metric (vertex)
/// Writes   surf:uv, surf:metric of inner vertices
/// Returns  the queries of the metric field
/// Cost     8 surface evaluations per quad, about 100 for those near the sag
/// Throws   Cancelled
QueryCounts divide_far_quads(PolyMesh& mesh, const Surface& surface, const MetricField& field,
                             std::size_t fixed, double sag, const RunContext& context);

}  // namespace surfmesh::detail
