// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/boundary/patch_boundary.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// The triangles of one patch in its domain, while they are still changed. The first vertices are
/// the nodes of the loops, in their order.
struct TriangulatedPatch {
  PatchBoundary boundary;
  std::unique_ptr<DelaunayMesh> delaunay;
  const Surface* surface = nullptr;
  const MetricField* field = nullptr;
  /// Positions of the vertices, and normals p_u × p_v, zero without a tangent plane; by
  /// evaluate_vertices.
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  /// True if triangles may be as stretched as the metric is; else their shapes count in space.
  bool has_shapes_of_metric = false;
};

/// Evaluate the surface at the vertices that have no position yet. A vertex that is moved later has
/// to get both anew.
void evaluate_vertices(TriangulatedPatch& patch);

/// Split an inner edge at a share of it in (u,v), from the origin of its first halfedge. The new
/// node gets its metric.
///
/// Returns  false, and does nothing, if the place as rounded does not lie strictly inside the two
///          triangles
bool split_chord(TriangulatedPatch& patch, EdgeHandle eh, double share = 0.5);

}  // namespace surfmesh
