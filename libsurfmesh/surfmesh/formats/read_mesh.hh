// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// A mesh as it stands in a file, before anything is mended.
struct MeshArraysFile {
  MeshArrays mesh;  ///< without values of corners
  Notices notices;  ///< with file and line
  /// Faces of an .stl file that are left out of the mesh, since two of their corners are one point;
  /// counted from 0 in the file.
  std::vector<std::size_t> degenerate_faces;
};

/// A mesh read from a file.
struct MeshFile {
  PolyMesh mesh;    ///< surf:patch (face) where the file has patches
  MeshNames names;  ///< of its patches; empty where the format has none
  Notices notices;  ///< with file and line
};

/// Read the faces of a mesh in the format of the ending, in upper or lower case.
///
/// .obj   positions, faces; faces with the same words of `g`, `o` and `usemtl` are one patch, named
///        after the last word of `g` (but "default" alone is no name), else by the material, else
///        by the object; the other names are groups, and so is a name that several patches would
///        have. Patches are in the order in which the file names them
/// .off   positions, faces
/// .ply   ASCII or binary of either byte order, with numbers of any type: x, y, z of `vertex`,
///        vertex_indices (or vertex_index) and `patch` of `face`; from the comments that write_mesh
///        makes names and groups, and the patches where faces have no `patch`; all else is skipped
/// .stl   ASCII or binary; corners with equal coordinates are one vertex; where there are several
///        solids each is a patch
/// .om    positions, faces, patches with their names and groups
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending and, naming file and
///          line (of text) or byte: a bad, missing or infinite number, a vertex index out of
///          range, a face with fewer than three different vertices (but see degenerate_faces) or
///          with one of them twice, a file cut short, no faces
/// Cost     0.15 µs a triangle for binary .ply, 0.2 to 0.3 µs for the others
MeshArraysFile read_mesh_arrays(const std::filesystem::path& path);

/// Read a mesh in the format of the ending.
///
/// Where the faces do not make a proper mesh, vertices are duplicated as build_faces does, and
/// faces of fewer than three different vertices left out: notices tell the counts. An .om file
/// has the mesh itself, with all its surf: properties; those of types that are neither numbers nor
/// of this library are left out.
///
/// Writes   surf:patch (face) where the file has patches; of .om files all that they have
/// Throws   as read_mesh_arrays; InvalidInput for an .om file whose connectivity is broken
MeshFile read_mesh(const std::filesystem::path& path);

/// Make a half-edge mesh of faces, as read_mesh does; `name` stands in notices. Values of corners
/// are not taken over.
MeshFile mesh_from(MeshArraysFile file, const std::string& name);

}  // namespace surfmesh
