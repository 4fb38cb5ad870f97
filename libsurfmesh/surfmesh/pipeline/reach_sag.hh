// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::detail {

/// Mesh a model with these sources; correct the triangles above a sag one by one, unless it is 0.
using MeshOnce = std::function<MeshResult(const Sources&, double corrected_sag)>;

/// Mesh a model so that mesh and surface are nowhere farther from each other than the sag asks.
///
/// The first mesh has the sizes that the curvature asks for. It is measured, and its vertices
/// become the control nodes of the next one, with sizes scaled by what the sag around them allows,
/// larger or smaller. In the next mesh triangles that are still too far are corrected one by one;
/// where that is not enough, smaller sizes are asked for at them alone, and the model is meshed
/// again, up to six times. Of those that reach the sag the mesh with the fewest triangles is taken,
/// else the nearest.
///
/// Reads    surf:patch (face), surf:uv, surf:metric (halfedge) of the meshes
/// Returns  the mesh; its report has the times of all meshes and the sag, with a shortfall if that
///          is not reached
/// Error    the sag is measured as by measure_sag
/// Cost     two to eight meshes, 15 µs a triangle to measure each
/// Pre      the sizing has a sag
/// Throws   as mesh_model
MeshResult reach_sag(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
                     const MeshOnce& mesh_once);

}  // namespace surfmesh::detail
