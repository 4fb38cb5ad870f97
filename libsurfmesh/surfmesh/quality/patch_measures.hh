// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// What a patch of a mesh is called and how much of the mesh it is.
struct PatchMeasure {
  std::string name = {};                 ///< empty where it has none
  std::vector<std::string> groups = {};  ///< that it is in
  std::size_t triangles = 0;
  std::size_t quads = 0;
  std::size_t polygons = 0;  ///< of more corners
  double area = 0;           ///< of the mesh, in square model units
  /// The least metric quality of its triangles, where it was measured: not by measure_patches.
  std::optional<double> least_quality = std::nullopt;
  /// The least scaled Jacobian of its quads in the metric, likewise.
  std::optional<double> least_jacobian = std::nullopt;

  friend bool operator==(const PatchMeasure&, const PatchMeasure&) = default;
};

/// Measure the patches of a mesh, in the order of their numbers: those that have a name or faces.
///
/// Reads    surf:patch (face; without it there are no patches)
/// Error    none but rounding: the area is that of the flat triangles, a polygon's that of a fan
/// Cost     O(corners), about 20 ns a triangle
std::vector<PatchMeasure> measure_patches(const PolyMesh& mesh, const MeshNames& names);

}  // namespace surfmesh
