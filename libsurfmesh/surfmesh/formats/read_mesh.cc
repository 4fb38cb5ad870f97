// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {
namespace {

void check_faces(const MeshArraysFile& file, const std::string& name) {
  if (!file.mesh.faces.empty()) return;
  const char* reason = file.degenerate_faces.empty() ? "the file has no faces"
                                                     : "no face has three different corners";
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", name, reason));
}

/// The contours of the sides of faces, as those of the edges: the sides of an edge have the same.
void set_contours(const MeshArrays& set, PolyMesh& mesh) {
  const auto contour_of = attach(mesh, keys::edge_contour, -1);
  for (const FaceHandle fh : mesh.faces()) {
    const std::size_t first = set.faces.first_corner(static_cast<std::size_t>(fh.idx()));
    std::size_t k = 0;
    // The halfedge of the first corner leads to it, see FirstSide.
    for_each_corner(mesh, fh, [&](HalfedgeHandle heh) {
      const int contour = set.contours[first + k++];
      const EdgeHandle side = mesh.edge_handle(mesh.next_halfedge_handle(heh));
      if (contour >= 0) mesh.property(contour_of, side) = contour;
    });
  }
}

/// Apart, so that the mesh, which cannot be moved, is made where it is returned to.
MeshFile made_from(MeshArraysFile file, const std::string& name) {
  MeshFile result{{}, std::move(file.mesh.names), std::move(file.notices), std::move(file.unread)};
  const MeshArrays& set = file.mesh;
  const Separation separation =
      build_faces(result.mesh, set.points.size(), set.faces, FirstSide::ToFirstCorner);
  if (separation.cut_edges > 0 || !separation.copied.empty()) {
    result.notices.push_back(warning(
        NoticeKind::CutEdges,
        fmt::format(
            "{}: the faces do not make a manifold mesh: {} sides of faces are left open and "
            "{} vertices are there twice",
            name, separation.cut_edges, separation.copied.size())));
  }
  for (std::size_t v = 0; v < result.mesh.n_vertices(); ++v) {
    const std::size_t given =
        v < set.points.size() ? v
                              : static_cast<std::size_t>(separation.copied[v - set.points.size()]);
    result.mesh.set_point(VertexHandle(static_cast<int>(v)), to_openmesh(set.points[given]));
  }
  if (!set.patches.empty()) {
    const auto patch_of = attach(result.mesh, keys::face_patch, -1);
    result.mesh.property(patch_of).data_vector() = set.patches;
  }
  if (!set.contours.empty()) set_contours(set, result.mesh);
  return result;
}

}  // namespace

MeshFile mesh_from(MeshArraysFile file, const std::string& name) {
  return tell_out_of_memory([&] { return made_from(std::move(file), name); },
                            [&] { return "while making the mesh of " + name; });
}

MeshArraysFile read_mesh_arrays(const std::filesystem::path& path) try {
  const MeshFormat& format = format_to_read(path);
  MeshArraysFile file = format.parse(read_file(path), path.string());
  check_faces(file, path.string());
  return file;
} catch (const std::bad_alloc&) {
  fail_without_memory("while reading " + path.string());
}

MeshFile read_mesh(const std::filesystem::path& path) try {
  const MeshFormat& format = format_to_read(path);
  if (format.parse_mesh != nullptr) return format.parse_mesh(read_file(path), path.string());
  return mesh_from(read_mesh_arrays(path), path.string());
} catch (const std::bad_alloc&) {
  fail_without_memory("while reading " + path.string());
}

}  // namespace surfmesh
