// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh::detail {

/// A triangle in space, whose corners have parameters on a surface.
struct SurfaceTriangle {
  std::array<Vec3, 3> points;
  std::array<Uv, 3> uvs;
};

using Weights = std::array<double, 3>;

/// The 25 points at which a triangle is compared with its surface, those nearest to the middle
/// first, where the distance is greatest.
const std::vector<Weights>& sag_samples();

/// The greatest distance of the surface from the plane of the triangle, over the samples.
///
/// Unlike the distance from the triangle it does not grow where parameters run unevenly and a
/// sample lies beyond a side, over the next triangle.
double plane_sag(const Surface& surface, const SurfaceTriangle& triangle);

}  // namespace surfmesh::detail
