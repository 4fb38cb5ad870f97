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

/// A mesh exactly as a file has it, before anything is corrected.
struct MeshArraysFile {
  MeshArrays mesh;  ///< without values at corners, but for contours where the file has lines
  Notices notices;  ///< with file and line
  /// Faces that are left out of the mesh because they do not have three different corners, or no
  /// inside, counted from 0 in the file. Notices tell them, too.
  std::vector<std::size_t> degenerate_faces;
  /// What the file has besides and is not read, in plain English: "normals (vn)".
  std::vector<std::string> unread = {};
};

/// A mesh read from a file.
struct MeshFile {
  PolyMesh mesh;                         ///< with surf:patch (face) if the file has patches
  MeshNames names;                       ///< of its patches; empty if the format has none
  Notices notices;                       ///< with file and line
  std::vector<std::string> unread = {};  ///< as in MeshArraysFile
};

/// Read the faces of a mesh. The ending, in upper or lower case, selects the format.
///
/// .obj   positions, faces; faces with the same words of `g`, `o` and `usemtl` are one patch. It is
///        named after the last word of `g` (but "default" alone is no name), otherwise after the
///        material, otherwise after the object. The other names are groups, and so is a name that
///        several patches would have. Patches are in the order in which the file names them.
///        Normals and texture coordinates are told in `unread`: the latter, from other programs,
///        need not be the (u,v) of a patch
/// .off   positions, faces
/// .ply   ASCII or binary in either byte order, with numbers of any type: x, y, z of `vertex`,
///        vertex_indices (or vertex_index) and `patch` of `face`. The comments that write_mesh
///        makes give names and groups, and patches if faces have no `patch`. All else is skipped
/// .stl   ASCII or binary; corners with equal coordinates are one vertex; if there are several
///        solids, each is a patch
/// .om    positions, faces, patches with their names and groups
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending and, naming the file
///          and the line (of text) or byte, for a bad, missing or infinite number, a vertex index
///          out of range, a face with fewer than three different vertices (but see
///          degenerate_faces) or with one of them twice, a truncated file, no faces
/// Cost     0.15 µs per triangle for binary .ply, 0.2 to 0.3 µs for the others
MeshArraysFile read_mesh_arrays(const std::filesystem::path& path);

/// Read a mesh. The ending selects the format.
///
/// If the faces do not form a proper mesh, vertices are duplicated as build_faces does, and faces
/// with fewer than three different vertices are left out; notices state how many. An .om file has
/// the mesh itself with all its surf: properties, except those whose type is neither a number nor
/// of this library.
///
/// Writes   surf:patch (face) and surf:contour (edge) if the file has patches and contours; all
///          properties of an .om file
/// Throws   as read_mesh_arrays; InvalidInput for an .om file whose connectivity is broken
MeshFile read_mesh(const std::filesystem::path& path);

/// Make a half-edge mesh from faces, as read_mesh does; `name` is for notices. Of values at corners
/// only contours are copied.
MeshFile mesh_from(MeshArraysFile file, const std::string& name);

}  // namespace surfmesh
