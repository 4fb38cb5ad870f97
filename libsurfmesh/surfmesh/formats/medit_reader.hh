// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {

/// The grid of a medit file: text, or binary of the versions 1 to 4, in either byte order. In two
/// dimensions, z is 0.
///
/// Patches are the references of faces in their growing order, if not all are 0. Edges with a
/// Reference n of faces is patch n - 1 if they count from 1 with few gaps; else patches are in the
/// order of the references. 0 is no patch. References of edges above 0 are contours, likewise.
/// Names and groups are those that write_mesh keeps in comments of text files.
///
/// Throws   InvalidInput with name:line, or name: byte, for what is wrong or cut short
/// Cost     O(bytes)
GridFile parse_medit_grid(std::string bytes, const std::string& name);

/// Add the values of a .sol or .solb file to its grid, as `sol`, or `sol1`, `sol2`, ... if there
/// are several. Vectors are left out.
///
/// Throws   as parse_medit_grid; InvalidInput if there are not as many as points
void add_medit_values(std::string bytes, const std::string& name, GridFile& grid);

/// The faces of such a file, for the table of mesh_format.cc.
inline MeshArraysFile parse_medit(std::string bytes, const std::string& name) {
  return mesh_of(parse_medit_grid(std::move(bytes), name));
}

}  // namespace surfmesh
