// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "fuzz/byte_reader.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/check_mesh.hh"

namespace surfmesh::fuzz {
namespace {

/// Larger ones take long.
constexpr std::size_t kMostFaces = 2000;

std::string name_for(const MeshFormat& format) { return std::string("mesh").append(format.ending); }

MeshFile read(const MeshFormat& format, const std::string& text) {
  if (format.parse_mesh != nullptr) return format.parse_mesh(text, name_for(format));
  return mesh_from(format.parse(text, name_for(format)), name_for(format));
}

/// Formats for elements have no polygons, and those of them in their own order. These refuse
/// nothing.
bool keeps_faces(const MeshFormat& format) {
  return format.ending == ".off" || format.ending == ".om" || format.ending == ".ply";
}

void compare(const PolyMesh& mesh, const PolyMesh& other) {
  demand(mesh.n_vertices() == other.n_vertices(), "as many vertices read back as were written");
  for (const VertexHandle vh : mesh.vertices()) {
    demand(mesh.point(vh) == other.point(vh), "positions read back exactly");
  }
  demand(mesh.n_faces() == other.n_faces(), "as many faces read back as were written");
}

void write_and_read(const MeshFile& file, const MeshFormat& format) {
  const std::filesystem::path path = scratch_folder() / name_for(format);
  const OutputOptions options{.normals = true, .uv = true};
  if (!accepts([&] { write_mesh(file.mesh, path, file.names, options); })) {
    demand(!keeps_faces(format), "what is read can be written");
    return;
  }
  what_is_lost(file.mesh, path, file.names, options);
  changed_names(file.mesh, path, file.names);
  if (format.parse == nullptr || file.mesh.n_faces() == 0) return;
  MeshFile again;
  try {
    again = read_mesh(path);
  } catch (const Error& error) {
    throw Finding(std::string("what is written reads back: ").append(error.what()));
  }
  check_proper(again.mesh, "read back");
  if (keeps_faces(format)) compare(file.mesh, again.mesh);
}

}  // namespace

bool try_result(Bytes input) {
  ByteReader bytes(input);
  const auto formats = formats_that([](const MeshFormat& f) { return f.parse != nullptr; });
  const MeshFormat& format = *bytes.one_of(formats);
  const MeshFormat& other = bytes.one_of(mesh_formats());
  const std::string text = bytes.rest();
  accepts([&] {
    MeshArraysFile arrays = format.parse(text, name_for(format));
    if (arrays.mesh.faces.size() > kMostFaces) return;
    demand(!to_json(check_mesh(arrays)).empty(), "the check of a mesh can be written");
  });
  return accepts([&] {
    const MeshFile file = read(format, text);
    if (file.mesh.n_faces() > kMostFaces) return;
    // Links of an .om file are as they were written: reading sees to it that they lead somewhere,
    // and `check` tells whether the mesh is proper.
    if (format.ending != ".om") check_proper(file.mesh, "read");
    write_and_read(file, other);
  });
}

}  // namespace surfmesh::fuzz
