// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

Rounding rounding_of(const PolyMesh& mesh, const std::filesystem::path& path) {
  return format_of(path).is_single_precision ? rounding_to_single(mesh) : Rounding();
}

std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const MeshNames& names) {
  return format_of(path).what_is_lost(mesh, names);
}

void write_mesh(const PolyMesh& mesh, OutputFile& file, const MeshNames& names) {
  format_of(file.path()).write(mesh, names, file);
}

void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path, const MeshNames& names) {
  format_of(path);  // an unknown ending is told before a file is made
  OutputFile file(path);
  write_mesh(mesh, file, names);
  file.commit();
}

}  // namespace surfmesh
