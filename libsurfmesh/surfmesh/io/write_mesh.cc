// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/write_mesh.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/om_file.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {
namespace {

/// Gathers text and hands it on in large pieces.
class TextWriter {
 public:
  explicit TextWriter(OutputFile& file) : file_(file) {}

  void text(std::string_view text) {
    if (text.size() > buffer_.size() - size_) flush();
    if (text.size() > buffer_.size()) return file_.write(text);
    std::copy(text.begin(), text.end(), buffer_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += text.size();
  }

  /// The shortest digits that read back as the same number, with a character before them.
  template <class Number>
  void number(char before, Number value) {
    if (buffer_.size() - size_ < kLongestNumber) flush();
    buffer_[size_++] = before;
    char* begin = buffer_.data() + size_;
    size_ +=
        static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
  }

  void flush() {
    file_.write({buffer_.data(), size_});
    size_ = 0;
  }

 private:
  /// More than the 24 characters of -2.2250738585072014e-308.
  static constexpr std::size_t kLongestNumber = 32;

  OutputFile& file_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 18);
  std::size_t size_ = 0;
};

void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh) {
  if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) return;
  throw Error(ErrorCode::Geometry, fmt::format("the position of vertex {} is ({}, {}, {})",
                                               vh.idx(), point[0], point[1], point[2]));
}

void write_points(const PolyMesh& mesh, std::string_view before_line, TextWriter& writer) {
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

void write_corners(const PolyMesh& mesh, FaceHandle fh, int first_index, TextWriter& writer) {
  const HalfedgeHandle start = mesh.halfedge_handle(fh);
  HalfedgeHandle heh = start;
  do {
    writer.number(' ', mesh.to_vertex_handle(heh).idx() + first_index);
    heh = mesh.next_halfedge_handle(heh);
  } while (heh != start);
}

/// A name as one word of an OBJ file, where blanks part the names of several groups.
std::string group_word(int patch, const std::vector<std::string>& names) {
  const bool has_name = patch >= 0 && static_cast<std::size_t>(patch) < names.size() &&
                        !names[static_cast<std::size_t>(patch)].empty();
  if (!has_name) return patch < 0 ? "none" : fmt::format("patch{}", patch);
  std::string word = names[static_cast<std::size_t>(patch)];
  for (char& c : word) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
  }
  if (word.front() == '#') word.front() = '_';
  if (word.back() == '\\') word.back() = '_';
  return word;
}

void write_obj(const PolyMesh& mesh, const std::vector<std::string>& patch_names,
               OutputFile& file) {
  const auto patch_of = find(mesh, keys::face_patch);
  std::vector<int> faces(mesh.n_faces());
  std::iota(faces.begin(), faces.end(), 0);
  if (patch_of.is_valid()) {
    const auto& patches = mesh.property(patch_of).data_vector();
    std::stable_sort(faces.begin(), faces.end(), [&patches](int a, int b) {
      return patches[static_cast<std::size_t>(a)] < patches[static_cast<std::size_t>(b)];
    });
  }
  TextWriter writer(file);
  writer.text("# surfmesh");
  write_points(mesh, "\nv", writer);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceHandle fh(faces[i]);
    if (patch_of.is_valid()) {
      const int patch = mesh.property(patch_of, fh);
      if (i == 0 || patch != mesh.property(patch_of, FaceHandle(faces[i - 1]))) {
        writer.text("\ng ");
        writer.text(group_word(patch, patch_names));
      }
    }
    writer.text("\nf");
    write_corners(mesh, fh, 1, writer);
  }
  writer.text("\n");
  writer.flush();
}

void write_off(const PolyMesh& mesh, OutputFile& file) {
  TextWriter writer(file);
  writer.text("OFF");
  writer.number('\n', mesh.n_vertices());
  writer.number(' ', mesh.n_faces());
  writer.text(" 0");
  write_points(mesh, "", writer);
  for (const FaceHandle fh : mesh.faces()) {
    writer.number('\n', mesh.valence(fh));
    write_corners(mesh, fh, 0, writer);
  }
  writer.text("\n");
  writer.flush();
}

}  // namespace

void check_mesh_ending(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 3> endings = {".obj", ".off", ".om"};
  if (std::find(endings.begin(), endings.end(), lower_case_ending(path)) == endings.end()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the ending of a mesh is .obj, .off or .om", path.string()));
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
  } else {
    write_om(mesh, file);
  }
  file.commit();
}

}  // namespace surfmesh
