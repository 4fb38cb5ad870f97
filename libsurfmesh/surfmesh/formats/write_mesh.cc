// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include <fmt/format.h>

#include <array>
#include <new>
#include <string_view>
#include <system_error>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {
namespace {

/// Warn that what an option asks for is not in the file; `values` are what it writes.
Notice unused(std::string_view option, std::string_view values, const std::filesystem::path& path,
              bool has_place) {
  const std::string cause = has_place ? fmt::format("has no effect: the mesh has no {}", values)
                                      : fmt::format("has no effect on {}: {} are written to {}",
                                                    path.string(), values, corner_value_endings());
  return warning(NoticeKind::UnusedOption, fmt::format("{} {}", option, cause));
}

}  // namespace

Rounding rounding_of(const PolyMesh& mesh, const std::filesystem::path& path) {
  return format_of(path).is_single_precision ? rounding_to_single(mesh) : Rounding();
}

std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const MeshNames& names, const OutputOptions& options) {
  return format_of(path).what_is_lost(mesh, names, options);
}

Notices unused_options(const PolyMesh& mesh, const std::filesystem::path& path,
                       const OutputOptions& options) {
  const bool has_place = format_of(path).has_corner_values;
  Notices notices;
  if (options.normals && !(has_place && find(mesh, keys::corner_normal).is_valid())) {
    notices.push_back(unused(ranges::kNormals.name, "normals of the corners", path, has_place));
  }
  if (options.uv && !(has_place && find(mesh, keys::corner_uv).is_valid())) {
    notices.push_back(unused(ranges::kUv.name, "parameters (u,v) of the corners", path, has_place));
  }
  const bool has_texture = find(mesh, keys::corner_texture).is_valid();
  if (options.texture && !(has_place && has_texture)) {
    notices.push_back(
        unused(ranges::kTexture.name, "texture coordinates of the corners", path, has_place));
  }
  if (options.uv && options.texture && has_texture && has_place &&
      format_of(path).ending != ".om") {
    notices.push_back(warning(NoticeKind::UnusedOption,
                              fmt::format("{} has no effect on {}: the texture coordinates of the "
                                          "cage stand in the place of (u,v)",
                                          ranges::kUv.name, path.string())));
  }
  if (options.msh != OutputOptions{}.msh && format_of(path).ending != ".msh") {
    notices.push_back(
        warning(NoticeKind::UnusedOption, fmt::format("{} has no effect on {}: it is of .msh files",
                                                      ranges::kMsh.name, path.string())));
  }
  return notices;
}

std::optional<std::filesystem::path> companion_of(const PolyMesh& mesh,
                                                  const std::filesystem::path& path) {
  const MeshFormat& format = format_of(path);
  if (format.has_companion == nullptr || !format.has_companion(mesh)) return std::nullopt;
  return std::filesystem::path(path).replace_extension(format.companion_ending);
}

void write_companion(const PolyMesh& mesh, const std::filesystem::path& path,
                     OutputFile& file) try {
  format_of(path).write_companion(mesh, file);
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing " + file.path().string());
}

Notices stale_companion(const PolyMesh& mesh, const std::filesystem::path& path) {
  const MeshFormat& format = format_of(path);
  if (format.has_companion == nullptr || format.has_companion(mesh)) return {};
  const auto beside = std::filesystem::path(path).replace_extension(format.companion_ending);
  std::error_code ignored;
  if (!std::filesystem::exists(beside, ignored)) return {};
  return {
      warning(NoticeKind::AmbiguousName,
              fmt::format("{} is there already and stays, but it is not of this mesh, which has "
                          "no metric: Mmg would take its sizes from it",
                          beside.string()))};
}

Notices changed_names(const PolyMesh& mesh, const std::filesystem::path& path,
                      const MeshNames& names) {
  const MeshFormat& format = format_of(path);
  if (!format.changed_names) return {};
  const std::vector<ChangedName> changed = format.changed_names(mesh, names);
  if (changed.empty()) return {};
  return {warning(
      NoticeKind::ChangedNames,
      fmt::format("{}: {} changed to be words of their own, the first: {} is {}", path.string(),
                  counted(changed.size(), "name of a patch, group or contour is", "names are"),
                  changed.front().name, changed.front().word))};
}

void write_mesh(const PolyMesh& mesh, OutputFile& file, const MeshNames& names,
                const OutputOptions& options) try {
  format_of(file.path()).write(mesh, names, options, file);
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing " + file.path().string());
}

void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path, const MeshNames& names,
                const OutputOptions& options) try {
  format_of(path);  // an unknown ending is told before a file is made
  OutputFile file(path);
  write_mesh(mesh, file, names, options);
  const auto beside = companion_of(mesh, path);
  if (!beside) return file.commit();
  OutputFile companion(*beside);
  write_companion(mesh, path, companion);
  OutputFile::commit_all(std::array{&file, &companion});
} catch (const std::bad_alloc&) {
  fail_without_memory("while writing " + path.string());
}

}  // namespace surfmesh
