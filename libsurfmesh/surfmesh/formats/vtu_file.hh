// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Values at the points or the cells of a grid, with `components` numbers each.
struct VtuValues {
  std::string name;
  int components = 1;
  std::variant<std::vector<double>, std::vector<int>> values;
};

/// The contents of a .vtu file: points, and cells (faces of any number of corners), with values.
struct VtuGrid {
  std::vector<Vec3> points;
  FaceList cells;
  std::vector<VtuValues> at_points;
  std::vector<VtuValues> at_cells;
  std::string tensors;  ///< name of the values at points that viewers use as tensors; may be empty
};

/// Write an unstructured grid for ParaView and VTK, as XML with numbers as text.
///
/// Throws   Io; Geometry for a position that is not finite
/// Cost     about 0.1 µs per number
void write_vtu(const VtuGrid& grid, OutputFile& file);

}  // namespace surfmesh
