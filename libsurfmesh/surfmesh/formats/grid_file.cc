// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/grid_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <system_error>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/medit_reader.hh"
#include "surfmesh/formats/msh_reader.hh"
#include "surfmesh/formats/vtu_reader.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {
namespace {

/// The file beside a path with one of these endings.
std::optional<std::filesystem::path> beside(std::filesystem::path path,
                                            std::initializer_list<const char*> endings) {
  for (const char* ending : endings) {
    path.replace_extension(ending);
    std::error_code unknown;  // counts as not there
    if (std::filesystem::exists(path, unknown)) return path;
  }
  return std::nullopt;
}

GridFile read_medit(const std::filesystem::path& mesh,
                    const std::optional<std::filesystem::path>& values) {
  GridFile grid = parse_medit_grid(read_file(mesh), mesh.string());
  if (values) add_medit_values(read_file(*values), values->string(), grid);
  return grid;
}

/// Number the points that faces use, in their order, and keep no others.
///
/// Returns  how many were left out
std::size_t drop_unused_points(GridFile& grid) {
  std::vector<int> number(grid.points.size(), -1);
  for (const int vertex : grid.faces.vertices()) number[static_cast<std::size_t>(vertex)] = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(count);
    grid.points[count++] = grid.points[i];
  }
  const std::size_t dropped = grid.points.size() - count;
  grid.points.resize(count);
  for (int& vertex : grid.faces.vertices()) vertex = number[static_cast<std::size_t>(vertex)];
  return dropped;
}

}  // namespace

GridFile read_grid(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  const std::string name = path.string();
  if (ending == ".msh") return parse_msh_grid(read_file(path), name);
  if (ending == ".vtu") return parse_vtu_grid(read_file(path), name);
  // Text goes with text, binary with binary, where both are there.
  if (ending == ".mesh") return read_medit(path, beside(path, {".sol", ".solb"}));
  if (ending == ".meshb") return read_medit(path, beside(path, {".solb", ".sol"}));
  if (ending == ".sol" || ending == ".solb") {
    const auto mesh =
        ending == ".sol" ? beside(path, {".mesh", ".meshb"}) : beside(path, {".meshb", ".mesh"});
    if (mesh) return read_medit(*mesh, path);
    throw Error(
        ErrorCode::Io,
        fmt::format("{}: its mesh, a .mesh or .meshb of the same name, is not there", name));
  }
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: the ending of a mesh with values at its vertices is .msh, .vtu, "
                          ".mesh, .meshb, .sol or .solb",
                          name));
}

MeshArraysFile mesh_of(GridFile grid) {
  MeshArraysFile file;
  file.unread = std::move(grid.unread);
  for (const GridValues& values : grid.at_points) {
    file.unread.push_back(fmt::format("values {}", values.name));
  }
  if (!grid.tetrahedra.empty()) {
    file.unread.push_back(fmt::format("{} tetrahedra", grid.tetrahedra.size()));
  }
  const std::size_t unused = drop_unused_points(grid);
  if (unused > 0) file.unread.push_back(fmt::format("{} points of no face", unused));
  file.mesh.points = std::move(grid.points);
  file.mesh.faces = std::move(grid.faces);
  file.mesh.patches = std::move(grid.patches);
  file.mesh.contours = std::move(grid.contours);
  file.mesh.names = std::move(grid.names);
  file.notices = std::move(grid.notices);
  file.degenerate_faces = std::move(grid.degenerate_faces);
  return file;
}

}  // namespace surfmesh
