// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/formats/mesh_endings.hh"

namespace surfmesh {

/// Write a mesh, whole or not at all, in the format of the ending in upper or lower case.
///
/// .obj   positions that read back exactly, faces in their order; before each change of the patch
///        `g GROUP... PATCH`, the groups of the patch and, as the last word, its name (without a
///        name "patch<index>"; blanks in names become _)
/// .off   positions that read back exactly, faces in their order
/// .ply   ASCII, which is what VTK, meshio and Gmsh all read: positions that read back exactly,
///        faces in their order, patches as the int property `patch` (in comments where faces have
///        different numbers of corners, for there meshio fails), names and groups in comments
/// .stl   binary: triangles with positions in single precision; other faces are split
/// .om    OpenMesh's own: everything, to the last bit, with all persistent properties
///
/// What else a format loses what_is_lost tells.
///
/// Reads    surf:patch (face; without it there are no groups or patches)
/// Throws   InvalidInput for an unknown ending, or for patches above 10 million in .obj; Io if it
///          cannot be written; Geometry if a format other than .om is to hold a position that is
///          not finite
/// Cost     0.1 µs a triangle for .obj, .off and .ply, 0.05 µs for .stl, 0.2 to 0.5 µs for .om
void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path,
                const MeshNames& names = {});

/// List what the format of the ending cannot hold of this mesh, in plain English, each to follow
/// "lost: "; empty if it holds everything.
///
/// Throws   InvalidInput for an unknown ending
std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const MeshNames& names = {});

}  // namespace surfmesh
