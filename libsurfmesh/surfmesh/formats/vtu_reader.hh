// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {

/// The grid of a VTU file of VTK: text, base64 or raw, in either byte order, compressed by zlib or
/// not.
///
/// Patches are the whole numbers `patch` at cells, as they are, or those of other programs
/// (gmsh:geometrical, gmsh:physical, medit:ref, CellEntityIds, ref) in their growing order.
/// Names and groups are those that write_mesh puts into the field data. Elements of higher order
/// give their corners.
///
/// Throws   InvalidInput with name:line, or name: byte, for what is wrong or cut short
/// Cost     O(bytes)
GridFile parse_vtu_grid(std::string bytes, const std::string& name);

/// The faces of such a file, for the table of mesh_format.cc.
inline MeshArraysFile parse_vtu(std::string bytes, const std::string& name) {
  return mesh_of(parse_vtu_grid(std::move(bytes), name));
}

}  // namespace surfmesh
