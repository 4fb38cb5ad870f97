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
/// Writers walk the half-edge mesh, not MeshArrays: for a million triangles those are 40 MB and
/// 20 ms more, of 50 to 250 ms, for nothing that the mesh does not tell as well.
struct MeshFormat {
  std::string_view ending;  ///< in lower case, with its dot

  /// Never null. Read the faces as they stand in the bytes of a file; `name` stands in messages.
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

  /// The names of patches and groups that are other words in the file, with those; null where
  /// names stay as they are, or there are none.
  std::vector<ChangedName> (*changed_names)(const PolyMesh& mesh, const MeshNames& names) = nullptr;
};

std::span<const MeshFormat> mesh_formats();

/// The format of the ending of a path, in upper or lower case; null if there is none.
const MeshFormat* find_format(const std::filesystem::path& path);

/// Throws   InvalidInput, naming the path and the endings
const MeshFormat& format_of(const std::filesystem::path& path);

/// What of this mesh only .om files hold, but for the values of corners that are `written`.
std::vector<std::string> lost_properties(const PolyMesh& mesh, const OutputOptions& written = {});

/// The same for formats without patches and groups.
std::vector<std::string> lost_patches_and_properties(const PolyMesh& mesh, const MeshNames& names);

/// How far positions move in single precision.
Rounding rounding_to_single(const PolyMesh& mesh);

}  // namespace surfmesh
