// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/patch/corner_triangles.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh::detail {

/// Measures the distance of triangles from a surface.
///
/// Error    from the planes of triangles, at 25 samples each and beyond; an estimate serves
///          for those that are surely below the aim
class SagMeter {
 public:
  SagMeter(const Surface& surface, double aim) : surface_(surface), aim_(aim) {}

  double sag_of(const CornerTriangle& triangle) const;

  /// The greatest one of triangles and of the sharp edges between them.
  double sag_of(const CornerTriangles& triangles) const;

  /// True if the sag is not above the aim, which takes fewer evaluations to tell.
  bool holds(const CornerTriangle& triangle) const;
  bool holds(const CornerTriangles& triangles) const;

  /// The greatest distance between the surface and the middles of the edges between some triangles,
  /// both ways: over a sharp bend the planes of the two triangles pass nearer than their edge. Only
  /// edges where the cosine between the normals is at most `most_cosine` count.
  double ridge_sag(const CornerTriangles& triangles, double most_cosine = INFINITY) const;

 private:
  double ridge_sag(const PatchCorner& a, const PatchCorner& b, const CornerTriangle& left,
                   const CornerTriangle& right) const;

  const Surface& surface_;
  double aim_;
};

}  // namespace surfmesh::detail
