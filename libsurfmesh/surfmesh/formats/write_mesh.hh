// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
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
/// FORMATS.md tells more of each, with recipes for other programs.
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
/// .vtu, .vtk   for ParaView and VTK, binary: points, faces, and the fields of mesh_field.hh that
/// the
///        mesh has; vtk_grid.hh tells what there is
/// .msh   Gmsh's, of the version and kind that the options ask for: a surface per patch, a curve
/// per
///        contour, physical names for named patches, groups and contours (msh_file.hh)
/// .mesh, .meshb   for medit, Mmg and others, text and binary: references for patches and contours,
///        corners, ridges; beside it the metric at the vertices as .sol or .solb (companion_of)
/// .glb   glTF 2.0: positions and normals in single precision, a material per patch; faces of more
///        corners are split
/// .inp   shells (S3, S4) with sets for Abaqus and CalculiX
/// .bdf   shells (CTRIA3, CQUAD4) with a property per patch for Nastran
/// .om    OpenMesh's own format: everything, to the last bit, with all persistent properties
///
/// what_is_lost lists what else a format cannot store.
///
/// Reads    surf:patch (face; without it the file has no groups or patches); surf:uv and
///          surf:normal (halfedge; if the options ask for them)
/// Throws   InvalidInput for an unknown ending, or for patches above 10 million in .obj; Io if the
///          file cannot be written; Geometry for a position, or for a value of a corner, that is
///          not finite, except in .om
/// Cost     per triangle 0.05 to 0.1 µs for .obj, .off, .ply and .stl, 0.2 to 0.5 µs for .om; the
///          others are in FORMATS.md
void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path,
                const MeshNames& names = {}, const OutputOptions& options = {});

/// Write a mesh to a file that is not finished yet, so that it can appear together with others
/// (OutputFile::commit_all), and without its companion. Otherwise as above.
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

/// The file that is written beside that of a mesh: the .sol with the metric beside a .mesh, if the
/// mesh has one; none of most formats.
///
/// Throws   InvalidInput for an unknown ending
std::optional<std::filesystem::path> companion_of(const PolyMesh& mesh,
                                                  const std::filesystem::path& path);

/// Write what belongs into companion_of(mesh, path), to be committed with the mesh.
///
/// Pre      there is one
/// Throws   as write_mesh
void write_companion(const PolyMesh& mesh, const std::filesystem::path& path, OutputFile& file);

/// Warn of a file that would be taken for the companion of this mesh, which has none: an old .sol
/// beside a .mesh, from which Mmg would take its sizes. It stays as it is.
///
/// Throws   InvalidInput for an unknown ending
Notices stale_companion(const PolyMesh& mesh, const std::filesystem::path& path);

/// Warn about names of patches, groups and contours that are others in the file, such as those with
/// blanks in .obj.
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
