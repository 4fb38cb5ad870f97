// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/formats/read_mesh.hh"

namespace surfmesh {

/// Numbers at the points of a grid, `components` for each.
///
/// Six are those of a symmetric tensor: xx, yy, zz, xy, yz, xz, as VTK has them; nine are its rows.
/// Numbers may be NaN or infinite.
struct GridValues {
  std::string name;
  int components = 1;
  std::vector<double> numbers;   ///< by point
  bool is_plane_tensor = false;  ///< three numbers are xx, xy, yy of a tensor in the plane
};

/// What files of solvers hold: faces, tetrahedra, values at points.
struct GridFile {
  std::vector<Vec3> points;
  FaceList faces;                              ///< at least three different vertices each
  std::vector<std::array<int, 4>> tetrahedra;  ///< vertices in range
  std::vector<int> patches;                    ///< by face, -1 for none; empty for none at all
  std::vector<int> contours;                   ///< by corner of `faces`, as in MeshArrays
  MeshNames names;                             ///< groups of patches, contours
  std::vector<GridValues> at_points;           ///< in the order of the file
  Notices notices;                             ///< with the file
  std::vector<std::size_t> degenerate_faces;   ///< as in MeshArraysFile
  std::vector<std::string> unread;             ///< as in MeshArraysFile
};

/// Read a grid with the values at its points. The ending, in upper or lower case, tells the format:
///
/// .msh            Gmsh, versions 4.1 and 2.2, text or binary; values are its views
/// .vtu            VTK, text or binary
/// .mesh, .meshb   medit; values are those of the .sol or .solb of the same name beside it, if
///                 there is one; where both are, .sol goes with .mesh, .solb with .meshb
/// .sol, .solb     the same from the other side: the mesh must be there
///
/// Throws   Io if a file cannot be read; InvalidInput for another ending, and with the file and the
///          line (of text) or byte for what is wrong there
GridFile read_grid(const std::filesystem::path& path);

/// The faces of a grid, with the points that they use.
MeshArraysFile mesh_of(GridFile grid);

}  // namespace surfmesh
