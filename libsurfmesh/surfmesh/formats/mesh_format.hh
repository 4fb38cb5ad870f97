// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/formats/output_options.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// A name, and what it is in a file.
struct ChangedName {
  std::string name;
  std::string word;
};

/// A format of meshes. Each is made in the file that is named after it and stands in the table of
/// mesh_format.cc; no other code chooses by it.
///
/// Writers of formats that keep vertices and faces in their order walk the half-edge mesh, not
/// arrays: for a million triangles those are 40 MB and 20 ms more, of 50 to 250 ms, for nothing
/// that the mesh does not tell as well. Others need arrays (mesh_elements.hh).
struct MeshFormat {
  std::string_view ending;  ///< in lower case, with its dot

  /// Read the faces as they stand in the bytes of a file; `name` stands in messages. Null where the
  /// format is only written.
  MeshArraysFile (*parse)(std::string bytes, const std::string& name) = nullptr;

  /// Read a mesh where the format holds its connectivity and properties; else null, and a mesh is
  /// made of the faces.
  MeshFile (*parse_mesh)(std::string bytes, const std::string& name) = nullptr;

  /// Read a control cage; null where the format is none of cages.
  Cage (*parse_cage)(std::string_view text, const std::string& name) = nullptr;

  /// Never null.
  void (*write)(const PolyMesh& mesh, const MeshNames& names, const OutputOptions& options,
                OutputFile& file) = nullptr;

  bool is_single_precision = false;  ///< positions are written so
  bool has_corner_values = false;    ///< there is a place for normals and parameters of corners

  /// Never null. As what_is_lost of write_mesh.hh.
  std::vector<std::string> (*what_is_lost)(const PolyMesh& mesh, const MeshNames& names,
                                           const OutputOptions& options) = nullptr;

  /// The names of patches, groups and contours that are other words in the file, with those; null
  /// where names stay as they are, or there are none.
  std::vector<ChangedName> (*changed_names)(const PolyMesh& mesh, const MeshNames& names) = nullptr;

  /// The ending of a file that is written beside that of the mesh, and its writer; empty and null
  /// where there is none. Meshes without what it holds have none either.
  std::string_view companion_ending = {};
  bool (*has_companion)(const PolyMesh& mesh) = nullptr;
  void (*write_companion)(const PolyMesh& mesh, OutputFile& file) = nullptr;
};

std::span<const MeshFormat> mesh_formats();

/// The format of the ending of a path, in upper or lower case; null if there is none.
const MeshFormat* find_format(const std::filesystem::path& path);

/// Throws   InvalidInput, naming the path and the endings
const MeshFormat& format_of(const std::filesystem::path& path);

/// The same, of a format that is read.
/// Throws   InvalidInput, likewise
const MeshFormat& format_to_read(const std::filesystem::path& path);

/// What a file has of the properties that only .om files hold as a whole.
struct KeptProperties {
  bool normals = false;
  bool uv = false;
  bool metric = false;
  bool contours = false;
  bool sag = false;
  bool texture = false;
};

/// What of this mesh only .om files hold, but for what is kept.
std::vector<std::string> lost_properties(const PolyMesh& mesh, const KeptProperties& kept = {});

/// The same for formats without patches and groups.
std::vector<std::string> lost_patches_and_properties(const PolyMesh& mesh, const MeshNames& names);

/// How far positions move in single precision.
Rounding rounding_to_single(const PolyMesh& mesh);

/// Add to what is lost the digits that do not fit into single precision.
void add_lost_digits(const PolyMesh& mesh, std::vector<std::string>& lost);

/// Add to what is lost the faces of more corners than `corners`, which are split.
void add_split_faces(const PolyMesh& mesh, std::size_t corners, std::vector<std::string>& lost);

/// Throws   Geometry, naming the vertex, for positions that are not finite or too large for single
///          precision; `ending` is that of the file
void check_single_precision(const PolyMesh& mesh, std::string_view ending);

}  // namespace surfmesh
