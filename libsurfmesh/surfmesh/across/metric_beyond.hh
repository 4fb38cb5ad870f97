// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/model/surface_walk.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh {

/// Give the corners of faces that lie on several patches the metrics that see their sides as the
/// vertices do on their own patches, where `metric_at` is asked for. Other faces stay as they are.
///
/// Vertices that no face has on its patch are searched.
/// Reads    surf:patch (face), surf:uv, surf:beyond (halfedge)
/// Writes   surf:metric (halfedge)
/// Cost     about 1 µs a corner of such faces, and the metrics
void set_metrics_beyond(PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                        const std::function<Metric(const SurfacePlace&)>& metric_at);

}  // namespace surfmesh
