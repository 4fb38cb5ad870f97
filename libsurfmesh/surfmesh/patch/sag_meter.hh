// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/patch/corner_triangles.hh"

namespace surfmesh::detail {

/// Measures the distance of triangles from a surface.
///
/// Error    from the planes of triangles, at 25 samples each; those that are below half of the aim
///          are not searched for beyond samples
class SagMeter {
 public:
  SagMeter(const Surface& surface, double aim) : surface_(surface), aim_(aim) {}

  double sag_of(const CornerTriangle& triangle) const;

  /// The greatest one of triangles and of the edges between them.
  double sag_of(const CornerTriangles& triangles) const;

  /// The greatest distance between the surface and the middles of the edges between some triangles,
  /// both ways: over a sharp bend the planes of the two triangles pass nearer than their edge.
  double ridge_sag(const CornerTriangles& triangles) const;

 private:
  double ridge_sag(const PatchCorner& a, const PatchCorner& b, const CornerTriangle& left,
                   const CornerTriangle& right) const;

  const Surface& surface_;
  double aim_;
};

}  // namespace surfmesh::detail
