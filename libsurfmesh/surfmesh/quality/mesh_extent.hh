// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh {

/// How large a mesh is, in model units.
struct MeshExtent {
  double area = 0;
  /// Enclosed by the faces if they are closed and oriented: below 0 if they face inwards. Parts
  /// that enclose each other count with their signs.
  double volume = 0;
  Eigen::AlignedBox3d box;  ///< of the vertices of faces; empty without any
};

/// Measure area, volume and box.
///
/// Error    none but rounding: polygons count as the fan of their first corner
/// Cost     O(corners), about 10 ns a triangle
MeshExtent measure_extent(const MeshArrays& set);

}  // namespace surfmesh
