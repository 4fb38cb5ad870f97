// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include <algorithm>

#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {
namespace {

double rounding_of(const OpenMesh::Vec3d& point) {
  // Not in OpenMesh's vectors: GCC 12 takes a conversion to float and back for nothing there.
  const Vec3 exact = to_eigen(point);
  return (exact.cast<float>().cast<double>() - exact).norm();
}

}  // namespace

Rounding rounding_of(const PolyMesh& mesh, const std::filesystem::path& path) {
  Rounding result;
  if (!format_of(path).is_single_precision) return result;
  for (const VertexHandle vh : mesh.vertices()) {
    result.greatest_move = std::max(result.greatest_move, rounding_of(mesh.point(vh)));
  }
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const OpenMesh::Vec3d& a = mesh.point(mesh.from_vertex_handle(heh));
    const OpenMesh::Vec3d& b = mesh.point(mesh.to_vertex_handle(heh));
    const double move = std::max(rounding_of(a), rounding_of(b));
    const double length = (b - a).norm();
    if (length > 0 && move > result.share * length) result.share = move / length;
  }
  return result;
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
