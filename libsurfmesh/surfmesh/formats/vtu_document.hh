// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/formats/vtu_arrays.hh"

namespace surfmesh::vtu {

/// A part of a grid, with arrays that are not decoded.
struct Piece {
  std::size_t points = 0;
  std::size_t cells = 0;
  std::vector<DataArray> coordinates;  ///< one, if all is well
  std::vector<DataArray> topology;     ///< connectivity, offsets, types
  std::vector<DataArray> at_points;
  std::vector<DataArray> at_cells;
  std::size_t line = 0;
};

struct Document {
  ArrayForm form;
  std::vector<Piece> pieces;
  std::vector<DataArray> whole;  ///< field data of the grid
};

/// Read the elements and attributes of a .vtu file. The bytes must outlive the document.
///
/// Throws   InvalidInput with name:line
Document read_document(std::string_view bytes, const std::string& name);

}  // namespace surfmesh::vtu
