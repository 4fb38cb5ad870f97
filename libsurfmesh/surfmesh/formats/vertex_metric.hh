// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/metric/space_metric.hh"

namespace surfmesh {

/// True if vertex_metrics can be made: every corner has its parameters and its metric.
bool has_vertex_metrics(const PolyMesh& mesh);

/// The metric in space at the vertices of a result, without copies of vertices: the mean of its
/// corners' there.
///
/// At a corner, M = J⁺ᵀ M_uv J⁺ + √(λ₁λ₂) nnᵀ, where J takes parameter steps to the flat face, the
/// λ are the eigenvalues of the first term in its plane, and n is its normal: across the surface
/// the metric asks for the geometric mean of the two sizes. Corners of flat faces are left out; a
/// vertex that has no other gets the geometric mean of all sizes.
///
/// Reads    surf:uv, surf:metric (halfedge), surf:original (vertex; optional)
/// Error    that of the flat face for the surface, O(size × curvature)
/// Cost     0.2 µs a vertex
/// Throws   MissingProperty; Geometry if no corner of the mesh has a metric that is positive
///          definite on its face
std::vector<SpaceMetric> vertex_metrics(const PolyMesh& mesh);

/// The size that each of these metrics asks for: the geometric mean of the two in the surface,
/// model units.
double size_of(const SpaceMetric& metric);

}  // namespace surfmesh
