// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/across/vertex_chart.hh"

namespace surfmesh {

/// Metric length of the edge between two vertices.
double metric_length(const VertexChart& a, const VertexChart& b);

/// True if the normals of three vertices are no more than 90° apart. A triangle between others
/// reaches around an edge of the surface that is rounded within less than an element, and cannot be
/// measured in space.
inline bool do_normals_agree(const VertexChart& a, const VertexChart& b, const VertexChart& c) {
  return a.normal.dot(b.normal) >= 0 && b.normal.dot(c.normal) >= 0 && c.normal.dot(a.normal) >= 0;
}

/// Quality of a triangle in the mean metric of its corners, in space as if it were flat, and in
/// (u,v) if all corners lie on one patch: the lower one. -1 if it is turned against the normal of a
/// corner, or if the normals do not agree.
double triangle_quality(const VertexChart& a, const VertexChart& b, const VertexChart& c);

}  // namespace surfmesh
