// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

struct ChangedName;

/// Values at the points or the cells of a grid, or of the grid as a whole, with `components`
/// numbers each.
struct VtkValues {
  std::string name;
  int components = 1;
  std::variant<std::vector<double>, std::vector<int>> values;
};

/// The contents of a .vtu or .vtk file: points, and cells (faces of any number of corners), with
/// values.
struct VtkGrid {
  std::vector<Vec3> points;
  FaceList cells;
  std::vector<VtkValues> at_points = {};
  std::vector<VtkValues> at_cells = {};
  std::vector<VtkValues> whole = {};  ///< what VTK calls field data
  std::string tensors = {};  ///< name of the values at points that viewers use as tensors, if any
};

/// What a viewer shows of a mesh.
///
/// Cells have each field of mesh_field.hh that the mesh has (patch and group as int, -1 for none)
/// and points have `valence`, by their names there. (u,v) are `u` and `v`, twice: cells have the
/// mean of their corners, each in its own patch, so that every cell has a colour; points have the
/// exact values, and NaN where the corners at a point differ: at seams, and between patches. So
/// filters for contour lines of u work inside of patches, and the mesh stays connected. Points have
/// `contour`, too: the least contour through them, -1 for none.
///
/// Names are those of arrays of the grid as a whole, because viewers show these and readers of
/// numbers do not stumble over them: "patch:NAME" holds the indices of the patches of that name,
/// "group:NAME" the patches of the group, "contour:NAME" the contours of that name.
///
/// Reads    surf:original (vertex), surf:contour (edge), surf:uv (halfedge), what mesh_field.hh
///          reads; all optional
/// Cost     0.1 µs a triangle, and 0.2 µs where it has a metric
VtkGrid vtk_grid(const PolyMesh& mesh, const MeshNames& names);

/// The arrays of a grid as a whole that hold the names of patches, groups and contours, in
/// characters that XML has.
std::vector<VtkValues> vtk_names(const MeshNames& names);

/// Names that have other characters.
std::vector<ChangedName> changed_in_vtk(const PolyMesh& mesh, const MeshNames& names);

/// What of a mesh the grid does not hold, as what_is_lost of write_mesh.hh.
std::vector<std::string> lost_in_grid(const PolyMesh& mesh);

/// What VTK calls a cell of so many corners: triangle, quad or polygon.
constexpr std::uint8_t vtk_cell_type(std::size_t corners) {
  return corners == 3 ? 5 : corners == 4 ? 9 : 7;
}

/// Throws   Geometry, naming the vertex, for a position that is not finite
void check_points(const VtkGrid& grid);

}  // namespace surfmesh
