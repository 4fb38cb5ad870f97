// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/mesh_extent.hh"

#include <cstddef>

namespace surfmesh {

MeshExtent measure_extent(const MeshArrays& set) {
  MeshExtent extent;
  for (const int vertex : set.faces.vertices()) {
    extent.box.extend(set.points[static_cast<std::size_t>(vertex)]);
  }
  // Far from the origin, volumes that reach to it would cancel.
  const Vec3 middle = extent.box.center();
  for (std::size_t f = 0; f < set.faces.size(); ++f) {
    const auto face = set.faces[f];
    const auto point = [&](std::size_t k) -> Vec3 {
      return set.points[static_cast<std::size_t>(face[k])] - middle;
    };
    Vec3 double_area = Vec3::Zero();
    for (std::size_t k = 2; k < face.size(); ++k) {
      double_area += (point(k - 1) - point(0)).cross(point(k) - point(0));
    }
    extent.area += double_area.norm() / 2;
    extent.volume += point(0).dot(double_area) / 6;
  }
  return extent;
}

}  // namespace surfmesh
