// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/formats/parse_cage.hh"
#include "surfmesh/formats/ply_file.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/formats/stl_file.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {
namespace {

constexpr std::string_view kNoGroup = "default";

FaceSetFile from_cage(Cage cage) {
  FaceSetFile file;
  file.set.points = std::move(cage.points);
  file.set.faces.reserve(cage.faces.size(), 3 * cage.faces.size());
  for (const std::vector<int>& face : cage.faces) file.set.faces.add(face);
  file.warnings = std::move(cage.warnings);
  return file;
}

/// Groups that are patches: those of `g` where there are any with faces, else materials.
std::vector<const Cage::FaceGroup*> patch_groups(const Cage& cage) {
  const auto is_used = [](const Cage::FaceGroup& group, bool is_material) {
    return group.is_material == is_material && group.name != kNoGroup;
  };
  const bool are_materials = std::none_of(
      cage.groups.begin(), cage.groups.end(),
      [&](const Cage::FaceGroup& group) { return is_used(group, false) && !group.faces.empty(); });
  std::vector<const Cage::FaceGroup*> groups;
  for (const Cage::FaceGroup& group : cage.groups) {
    if (is_used(group, are_materials)) groups.push_back(&group);
  }
  return groups;
}

FaceSetFile read_obj(const std::filesystem::path& path) {
  Cage cage = parse_obj(read_file(path), path.string(), ReadFor::Mesh);
  const auto groups = patch_groups(cage);
  std::vector<int> patches(groups.empty() ? 0 : cage.faces.size(), -1);
  std::vector<std::string> names;
  std::size_t more = 0;
  for (std::size_t p = 0; p < groups.size(); ++p) {
    names.push_back(groups[p]->name);
    for (const int face : groups[p]->faces) {
      int& patch = patches[static_cast<std::size_t>(face)];
      if (patch >= 0) ++more;
      if (patch < 0) patch = static_cast<int>(p);
    }
  }
  FaceSetFile file = from_cage(std::move(cage));
  file.set.patches = std::move(patches);
  file.patch_names = std::move(names);
  if (more > 0) {
    file.warnings.push_back(
        fmt::format("{}: the first group of a face is its patch, {} further ones are ignored",
                    path.string(), more));
  }
  return file;
}

void check_faces(const FaceSetFile& file, const std::string& name) {
  if (!file.set.faces.empty()) return;
  const char* reason = file.degenerate_faces.empty() ? "the file has no faces"
                                                     : "all triangles have two equal corners";
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", name, reason));
}

}  // namespace

FaceSet face_set_of(const PolyMesh& mesh) {
  FaceSet set;
  set.points.reserve(mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) set.points.push_back(to_eigen(mesh.point(vh)));
  set.faces.reserve(mesh.n_faces(), mesh.n_halfedges());
  std::vector<int> face;
  for (const FaceHandle fh : mesh.faces()) {
    face.clear();
    for_each_corner(mesh, fh, [&face](int vertex) { face.push_back(vertex); });
    set.faces.add(face);
  }
  const auto patch_of = find(mesh, keys::face_patch);
  if (patch_of.is_valid()) set.patches = mesh.property(patch_of).data_vector();
  return set;
}

MeshFile mesh_from(FaceSetFile file, const std::string& name) {
  MeshFile result{{}, std::move(file.patch_names), std::move(file.warnings)};
  const FaceSet& set = file.set;
  const Separation separation =
      build_faces(result.mesh, set.points.size(), set.faces, FirstSide::ToFirstCorner);
  if (!file.degenerate_faces.empty()) {
    result.warnings.push_back(
        fmt::format("{}: {} triangles with two equal corners are left out, the first is number {}",
                    name, file.degenerate_faces.size(), file.degenerate_faces.front()));
  }
  if (separation.cut_edges > 0 || !separation.copied.empty()) {
    result.warnings.push_back(fmt::format(
        "{}: the faces do not make a manifold mesh: {} sides of faces are left open and "
        "{} vertices are there twice",
        name, separation.cut_edges, separation.copied.size()));
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
  return result;
}

FaceSetFile read_face_set(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  check_mesh_ending(path);
  FaceSetFile file;
  if (ending == ".obj") {
    file = read_obj(path);
  } else if (ending == ".off") {
    file = from_cage(parse_off(read_file(path), path.string(), ReadFor::Mesh));
  } else if (ending == ".ply") {
    file = parse_ply(read_file(path), path.string());
  } else if (ending == ".stl") {
    file = parse_stl(read_file(path), path.string());
  } else {
    file.set = face_set_of(read_om(path));
  }
  check_faces(file, path.string());
  return file;
}

MeshFile read_mesh(const std::filesystem::path& path) {
  if (lower_case_ending(path) == ".om") return {read_om(path), {}, {}};
  return mesh_from(read_face_set(path), path.string());
}

}  // namespace surfmesh
