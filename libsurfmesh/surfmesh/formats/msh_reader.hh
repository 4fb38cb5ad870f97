// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {

/// The grid of a Gmsh file, version 4.1 or 2.2, text or binary in either byte order.
///
/// Patches are the surface entities: faces with the same entity and physical groups. Entity n is
/// patch n - 1 if they count from 1 with few gaps; else patches are in their order. Physical groups
/// of surfaces are groups; one with the number of its only surface is the name of that patch. Lines
/// are contours, those of one physical name together. Elements of higher order give their corners.
/// Values are those of views: of nodes, or means of those of the nodes of elements.
///
/// Throws   InvalidInput with name:line, or name: byte, for what is wrong or cut short
/// Cost     O(bytes)
GridFile parse_msh_grid(std::string bytes, const std::string& name);

/// The faces of such a file, for the table of mesh_format.cc.
inline MeshArraysFile parse_msh(std::string bytes, const std::string& name) {
  return mesh_of(parse_msh_grid(std::move(bytes), name));
}

}  // namespace surfmesh
