// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh::compare {

/// Triangles as other programs exchange them.
struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Read the text of a Gmsh file, ASCII format 2. Points and lines among the elements are skipped.
///
/// `name` stands in the texts of errors.
/// Throws   InvalidInput naming the line of what is missing, no number, or out of range
TriangleMesh read_msh(std::string_view text, const std::string& name);

/// Read the text of a medit file, ASCII, in two or three dimensions. Sections other than vertices
/// and triangles are skipped.
///
/// Throws   as read_msh
TriangleMesh read_medit(std::string_view text, const std::string& name);

/// Read a .msh or .mesh file by the readers above, any other by the library.
///
/// Throws   as read_msh; Io if the file cannot be read
TriangleMesh read_triangles(const std::filesystem::path& path);

/// Throws   Io if the file cannot be written
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);

/// Throws   Io if the file cannot be written
void write_medit(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace surfmesh::compare
