// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/face_set.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// A mesh as it stands in a file, before anything is mended.
struct FaceSetFile {
  FaceSet set;
  std::vector<std::string> patch_names;  ///< by patch; empty where the format has none
  std::vector<std::string> warnings;     ///< with file and place
  /// Faces of an .stl file that are left out of the set, since two of their corners are one point;
  /// counted from 0 in the file.
  std::vector<std::size_t> degenerate_faces;
};

/// A mesh read from a file.
struct MeshFile {
  PolyMesh mesh;                         ///< surf:patch (face) where the file has patches
  std::vector<std::string> patch_names;  ///< by patch; empty where the format has none
  std::vector<std::string> warnings;     ///< with file and place
};

/// Read the faces of a mesh in the format of the ending, in upper or lower case.
///
/// .obj   positions, faces; a group (where there is none, a material) is a patch, patches are
///        numbered in the order in which the file names them; faces of the group "default" have
///        none, of several groups the first counts
/// .off   positions, faces
/// .ply   ASCII or binary of either byte order, with numbers of any type: x, y, z of `vertex`,
///        vertex_indices (or vertex_index) and `patch` of `face`; names of patches from the
///        comments `patch <number> <name>`; all else is skipped
/// .stl   ASCII or binary; corners with equal coordinates are one vertex; where there are several
///        solids each is a patch
/// .om    as read_om
///
/// Throws   Io if the file cannot be read; InvalidInput for an unknown ending and, naming file and
///          line (of text) or byte: a bad, missing or infinite number, a vertex index out of
///          range, a face with fewer than three different vertices (but see degenerate_faces) or
///          with one of them twice, a file cut short, no faces
/// Cost     0.15 µs a triangle for binary .ply, 0.2 to 0.3 µs for the others
FaceSetFile read_face_set(const std::filesystem::path& path);

/// Read a mesh in the format of the ending.
///
/// Where the faces do not make a proper mesh, vertices are duplicated as build_faces does, and
/// faces of fewer than three different vertices left out: the warnings tell the counts.
///
/// Writes   surf:patch (face) where the file has patches; of .om files all that they have
/// Throws   as read_face_set
MeshFile read_mesh(const std::filesystem::path& path);

/// Make a half-edge mesh of what was read, as read_mesh does; `name` stands in warnings.
MeshFile mesh_from(FaceSetFile file, const std::string& name);

/// The faces of a mesh with their patches.
/// Reads    surf:patch (face; optional)
FaceSet face_set_of(const PolyMesh& mesh);

}  // namespace surfmesh
