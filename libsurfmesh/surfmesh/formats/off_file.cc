// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/off_file.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, ReadFor purpose)
      : text_size_(text.size()),
        text_(text, name, TextScanner::Joining::Off, purpose),
        scanner_(text_.scanner) {}

  Cage read() {
    text_.begin();
    read_counts(read_header());
    read_vertices();
    read_faces();
    if (scanner_.next_line()) {
      text_.warnings.add(scanner_.line(), "the lines after the last face are ignored");
    }
    text_.check_not_empty();
    return text_.finish();
  }

 private:
  std::string_view read_header();
  void read_counts(std::string_view first);
  void read_vertices();
  void read_faces();
  void next_element(std::string_view what, int done, int count);
  std::size_t likely(int count) const;

  std::size_t text_size_;
  CageText text_;
  TextScanner& scanner_;
  int vertex_count_ = 0;
  int face_count_ = 0;
  bool has_extra_columns_ = false;
};

/// Read the header, if there is one, and return the first word after it.
std::string_view OffReader::read_header() {
  const std::string_view word = scanner_.next_word();
  if (!word.ends_with("OFF")) return word;
  std::string_view prefix = word.substr(0, word.size() - 3);
  has_extra_columns_ = !prefix.empty();
  if (prefix.starts_with("ST")) prefix.remove_prefix(2);
  if (prefix.starts_with('C')) prefix.remove_prefix(1);
  if (prefix.starts_with('N')) prefix.remove_prefix(1);
  if (!prefix.empty()) {
    scanner_.fail(fmt::format("the header {} is none of OFF, STOFF, COFF, NOFF", quoted(word)));
  }
  std::string_view first = scanner_.next_word();
  if (first == "BINARY") scanner_.fail("binary OFF files are not read");
  if (!first.empty()) return first;
  if (!scanner_.next_line()) scanner_.fail("the file ends before the counts");
  return scanner_.next_word();
}

void OffReader::read_counts(std::string_view first) {
  vertex_count_ = scanner_.to_integer(first, "the count of vertices");
  face_count_ = scanner_.to_integer(scanner_.next_word(), "the count of faces");
  if (vertex_count_ < 0 || face_count_ < 0) scanner_.fail("a count is negative");
}

/// Counts may lie: room is made for no more lines than the text can hold.
std::size_t OffReader::likely(int count) const {
  return std::min(static_cast<std::size_t>(count), text_size_ / 6 + 1);
}

void OffReader::next_element(std::string_view what, int done, int count) {
  if (scanner_.next_line()) return;
  scanner_.fail(fmt::format("the file ends after {} of {} {}", done, count, what));
}

void OffReader::read_vertices() {
  text_.cage.points.reserve(likely(vertex_count_));
  for (int i = 0; i < vertex_count_; ++i) {
    next_element("vertices", i, vertex_count_);
    text_.cage.points.push_back(scanner_.next_point());
    if (has_extra_columns_) continue;
    const std::string_view extra = scanner_.next_word();
    if (extra.empty()) continue;
    scanner_.to_number(extra, "a value after the coordinates");
    text_.warnings.add(scanner_.line(), "values after the coordinates are ignored");
  }
}

void OffReader::read_faces() {
  text_.cage.faces.reserve(likely(face_count_));
  std::vector<int> corners;
  for (int i = 0; i < face_count_; ++i) {
    next_element("faces", i, face_count_);
    const int corner_count =
        scanner_.to_integer(scanner_.next_word(), "the vertex count of a face");
    if (corner_count < 3) scanner_.fail("a face has fewer than three different vertices");
    corners.clear();
    for (int k = 0; k < corner_count; ++k) {
      const std::string_view word = scanner_.next_word();
      if (word.empty()) {
        scanner_.fail(fmt::format("a face has {} of {} vertices", k, corner_count));
      }
      const int vertex = scanner_.to_integer(word, "a vertex index");
      if (vertex < 0 || vertex >= vertex_count_) {
        scanner_.fail(fmt::format("vertex index {} is not in 0 to {}", vertex, vertex_count_ - 1));
      }
      corners.push_back(vertex);
    }
    text_.add_face(corners);
  }
}

MeshArraysFile parse_off_mesh(std::string text, const std::string& name) {
  return arrays_of(OffReader(text, name, ReadFor::Mesh).read());
}

void write_off(const PolyMesh& mesh, const MeshNames&, OutputFile& file) {
  FileWriter writer(file);
  writer.text("OFF");
  writer.number('\n', mesh.n_vertices());
  writer.number(' ', mesh.n_faces());
  writer.text(" 0");
  write_points(mesh, "", writer);
  for (const FaceHandle fh : mesh.faces()) {
    writer.number('\n', mesh.valence(fh));
    for_each_vertex_of(mesh, fh, [&writer](int vertex) { writer.number(' ', vertex); });
  }
  writer.text("\n");
  writer.flush();
}

}  // namespace

Cage parse_off(std::string_view text, const std::string& name) {
  return OffReader(text, name, ReadFor::Cage).read();
}

MeshFormat off_format() {
  return {.ending = ".off",
          .parse = parse_off_mesh,
          .parse_cage = parse_off,
          .write = write_off,
          .what_is_lost = lost_patches_and_properties};
}

}  // namespace surfmesh
