// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/output_options.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Write a mesh completely or not at all. The ending, in upper or lower case, selects the format.
///
/// .obj   positions that read back exactly, faces in their order; where the patch changes, a line
///        `g GROUP... PATCH` with the groups of the patch and, as the last word, its name
///        ("patch<index>" if it has none; blanks in names become _). On wish, the parameters of the
///        corners as `vt`, as they are, and their normals as `vn`, once for each vertex where they
///        are equal
/// .off   positions that read back exactly, faces in their order
/// .ply   ASCII, which VTK, meshio and Gmsh all read: positions that read back exactly, faces in
///        their order, patches as the int property `patch` (in comments if faces have different
///        numbers of corners, because meshio fails on these), names and groups in comments
/// .stl   binary: triangles with positions in single precision; other faces are split
/// .om    OpenMesh's own format: everything, to the last bit, with all persistent properties
///
/// what_is_lost lists what else a format cannot store.
///
/// Reads    surf:patch (face; without it the file has no groups or patches); surf:uv and
///          surf:normal (halfedge; if the options ask for them)
/// Throws   InvalidInput for an unknown ending, or for patches above 10 million in .obj; Io if the
///          file cannot be written; Geometry for a position, or for a value of a corner, that is
///          not finite, except in .om
/// Cost     0.1 µs per triangle for .obj, .off and .ply, 0.05 µs for .stl, 0.2 to 0.5 µs for .om
void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path,
                const MeshNames& names = {}, const OutputOptions& options = {});

/// Write a mesh to a file that is not finished yet, so that it can appear together with others
/// (OutputFile::commit_all). Otherwise as above.
void write_mesh(const PolyMesh& mesh, OutputFile& file, const MeshNames& names = {},
                const OutputOptions& options = {});

/// List what the format of the ending cannot store of this mesh, in plain English. Each entry reads
/// well after "lost: "; empty if the format stores everything.
///
/// Throws   InvalidInput for an unknown ending
std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const MeshNames& names = {},
                                      const OutputOptions& options = {});

/// Warn about options without effect: the format of the ending has no place for what they ask for,
/// or the mesh does not have it.
///
/// Throws   InvalidInput for an unknown ending
Notices unused_options(const PolyMesh& mesh, const std::filesystem::path& path,
                       const OutputOptions& options);

/// Warn about names of patches and groups that are others in the file: those with blanks in .obj.
///
/// Throws   InvalidInput for an unknown ending
Notices changed_names(const PolyMesh& mesh, const std::filesystem::path& path,
                      const MeshNames& names);

/// How far positions move when a mesh is written in a format of single precision.
struct Rounding {
  double greatest_move = 0;  ///< of a vertex, model units; 0 where the format keeps all digits
  double share = 0;          ///< greatest share of its length by which an end of an edge moves
};

/// Throws   InvalidInput for an unknown ending
Rounding rounding_of(const PolyMesh& mesh, const std::filesystem::path& path);

}  // namespace surfmesh
