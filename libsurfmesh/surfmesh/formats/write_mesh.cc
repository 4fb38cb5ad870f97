// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/om_file.hh"
#include "surfmesh/formats/ply_file.hh"
#include "surfmesh/formats/stl_file.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh) {
  if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) return;
  throw Error(ErrorCode::Geometry, fmt::format("the position of vertex {} is ({}, {}, {})",
                                               vh.idx(), point[0], point[1], point[2]));
}

namespace {

void write_points(const PolyMesh& mesh, std::string_view before_line, FileWriter& writer) {
  for (const VertexHandle vh : mesh.vertices()) {
    const OpenMesh::Vec3d& point = mesh.point(vh);
    check_finite(point, vh);
    if (before_line.empty()) {
      writer.number('\n', point[0]);
    } else {
      writer.text(before_line);
      writer.number(' ', point[0]);
    }
    writer.number(' ', point[1]);
    writer.number(' ', point[2]);
  }
}

/// A name as one word of an OBJ file, where blanks part the names of several groups.
std::string word_of(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
  }
  if (name.front() == '#') name.front() = '_';
  if (name.back() == '\\') name.back() = '_';
  return name;
}

/// The group of each patch: words that differ. "default" means faces without a patch.
std::vector<std::string> group_words(std::size_t count, const std::vector<std::string>& names) {
  std::unordered_set<std::string> used = {"default"};
  std::vector<std::string> words;
  for (std::size_t p = 0; p < count; ++p) {
    const bool has_name = p < names.size() && !names[p].empty();
    const std::string first = has_name ? word_of(names[p]) : fmt::format("patch{}", p);
    std::string word = first;
    for (int i = 2; !used.insert(word).second; ++i) word = fmt::format("{}_{}", first, i);
    words.push_back(std::move(word));
  }
  return words;
}

/// True if patches come up in the order of their numbers, without gaps, in the faces.
bool are_in_order(const std::vector<int>& patches, std::size_t count) {
  int seen = 0;
  for (const int patch : patches) {
    if (patch > seen) return false;
    if (patch == seen) ++seen;
  }
  return seen == static_cast<int>(count);
}

/// Writes the groups of an OBJ file, which change between the faces.
class GroupWriter {
 public:
  GroupWriter(const PolyMesh& mesh, const std::vector<std::string>& names, FileWriter& writer)
      : mesh_(mesh), patch_of_(find(mesh, keys::face_patch)), writer_(writer) {
    if (!patch_of_.is_valid()) return;
    const std::vector<int>& patches = mesh.property(patch_of_).data_vector();
    const int most = patches.empty() ? -1 : *std::max_element(patches.begin(), patches.end());
    const std::size_t count = std::max(names.size(), static_cast<std::size_t>(most + 1));
    words_ = group_words(count, names);
    if (are_in_order(patches, count)) return;
    for (const std::string& word : words_) write(word);
  }

  void begin_face(FaceHandle fh) {
    if (!patch_of_.is_valid()) return;
    const int patch = mesh_.property(patch_of_, fh);
    if (has_faces_ && patch == patch_) return;
    patch_ = patch;
    has_faces_ = true;
    write(patch < 0 ? "" : words_[static_cast<std::size_t>(patch)]);
  }

 private:
  void write(std::string_view word) {
    writer_.text(word.empty() ? "\ng" : "\ng ");
    writer_.text(word);
  }

  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_of_;
  FileWriter& writer_;
  std::vector<std::string> words_;
  int patch_ = -1;
  bool has_faces_ = false;
};

void write_obj(const PolyMesh& mesh, const std::vector<std::string>& patch_names,
               OutputFile& file) {
  FileWriter writer(file);
  writer.text("# surfmesh");
  write_points(mesh, "\nv", writer);
  GroupWriter groups(mesh, patch_names, writer);
  for (const FaceHandle fh : mesh.faces()) {
    groups.begin_face(fh);
    writer.text("\nf");
    for_each_corner(mesh, fh, [&writer](int vertex) { writer.number(' ', vertex + 1); });
  }
  writer.text("\n");
  writer.flush();
}

void write_off(const PolyMesh& mesh, OutputFile& file) {
  FileWriter writer(file);
  writer.text("OFF");
  writer.number('\n', mesh.n_vertices());
  writer.number(' ', mesh.n_faces());
  writer.text(" 0");
  write_points(mesh, "", writer);
  for (const FaceHandle fh : mesh.faces()) {
    writer.number('\n', mesh.valence(fh));
    for_each_corner(mesh, fh, [&writer](int vertex) { writer.number(' ', vertex); });
  }
  writer.text("\n");
  writer.flush();
}

template <class Mesh, class Key>
bool has(const Mesh& mesh, const Key& key) {
  return find(mesh, key).is_valid();
}

bool has_names(const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), [](const std::string& n) { return !n.empty(); });
}

bool has_contours(const PolyMesh& mesh) {
  const auto contour_of = find(mesh, keys::edge_contour);
  if (!contour_of.is_valid()) return false;
  const auto& contours = mesh.property(contour_of).data_vector();
  return std::any_of(contours.begin(), contours.end(), [](int contour) { return contour >= 0; });
}

/// Names of patches that are other words in an OBJ file.
std::size_t count_changed_names(const std::vector<std::string>& names) {
  const std::vector<std::string> words = group_words(names.size(), names);
  std::size_t count = 0;
  for (std::size_t p = 0; p < names.size(); ++p) {
    if (!names[p].empty() && names[p] != words[p]) ++count;
  }
  return count;
}

std::size_t count_polygons(const PolyMesh& mesh) {
  std::size_t count = 0;
  for (const FaceHandle fh : mesh.faces()) count += mesh.valence(fh) > 3 ? 1 : 0;
  return count;
}

/// What only .om files hold.
void add_lost_properties(const PolyMesh& mesh, std::vector<std::string>& lost) {
  if (has(mesh, keys::corner_uv)) lost.push_back("the parameters (u,v) of the corners");
  if (has(mesh, keys::corner_metric)) lost.push_back("the metric of the corners");
  if (has_contours(mesh)) lost.push_back("the contours of the edges");
  if (has(mesh, keys::vertex_uv)) lost.push_back("the parameters (u,v) of the vertices");
  if (has(mesh, keys::vertex_size)) lost.push_back("the sizes of the vertices");
  if (has(mesh, keys::vertex_metric)) lost.push_back("the metric of the vertices");
}

}  // namespace

std::vector<std::string> what_is_lost(const PolyMesh& mesh, const std::filesystem::path& path,
                                      const std::vector<std::string>& patch_names) {
  check_mesh_ending(path);
  const std::string ending = lower_case_ending(path);
  std::vector<std::string> lost;
  const bool has_patches = has(mesh, keys::face_patch);
  if (ending == ".om") {
    if (has_patches && has_names(patch_names)) lost.push_back("the names of the patches");
    return lost;
  }
  const bool holds_patches = ending == ".obj" || ending == ".ply";
  if (has_patches && !holds_patches) lost.push_back("the patches of the faces");
  if (has_patches && ending == ".obj" && count_changed_names(patch_names) > 0) {
    lost.push_back(fmt::format("{} names of patches, which are changed to be words of their own",
                               count_changed_names(patch_names)));
  }
  if (ending == ".stl") {
    lost.push_back("the digits of positions beyond single precision");
    if (const std::size_t count = count_polygons(mesh); count > 0) {
      lost.push_back(fmt::format("{} faces of more than three corners, which are split", count));
    }
  }
  add_lost_properties(mesh, lost);
  return lost;
}

void check_mesh_ending(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 5> endings = {".obj", ".off", ".ply", ".stl", ".om"};
  if (std::find(endings.begin(), endings.end(), lower_case_ending(path)) == endings.end()) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("{}: the ending of a mesh is .obj, .off, .ply, .stl or .om", path.string()));
  }
}

void write_mesh(const PolyMesh& mesh, const std::filesystem::path& path,
                const std::vector<std::string>& patch_names) {
  check_mesh_ending(path);
  const std::string ending = lower_case_ending(path);
  OutputFile file(path);
  if (ending == ".obj") {
    write_obj(mesh, patch_names, file);
  } else if (ending == ".off") {
    write_off(mesh, file);
  } else if (ending == ".ply") {
    write_ply(mesh, patch_names, file);
  } else if (ending == ".stl") {
    write_stl(mesh, file);
  } else {
    write_om(mesh, file);
  }
  file.commit();
}

}  // namespace surfmesh
