// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const MeshNames& names) {
  return format_of(path).what_is_lost(mesh, names);
}

void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path, const MeshNames& names) {
  const MeshFormat& format = format_of(path);
  OutputFile file(path);
  format.write(mesh, names, file);
  file.commit();
}

}  // namespace surfmesh
