// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/off_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// How vertices and faces stand in the text.
enum class Layout {
  Lines,  ///< each on a line of its own, maybe with more values behind
  Free    ///< lines end anywhere; there are no more values
};

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& name, ReadFor purpose, Layout layout)
      : text_size_(text.size()),
        layout_(layout),
        text_(text, name, TextScanner::Joining::Off, purpose),
        scanner_(text_.scanner) {}

  Cage read() {
    text_.begin();
    read_counts(read_header());
    read_vertices();
    read_faces();
    read_end();
    text_.check_not_empty();
    return text_.finish();
  }

  std::vector<std::size_t> left_out() const { return text_.left_out_of_mesh(); }

 private:
  std::string_view read_header();
  void read_prefix(std::string_view prefix, std::string_view word);
  void read_counts(std::string_view first);
  void read_vertices();
  Vec3 read_point();
  void read_more_of_vertex();
  void read_faces();
  void read_corners(int count, std::vector<int>& corners);
  void read_end();
  void next_element(std::string_view what, int done, int count);
  std::string_view next_word();
  std::size_t likely(int count) const;

  std::size_t text_size_;
  Layout layout_;
  CageText text_;
  TextScanner& scanner_;
  int vertex_count_ = 0;
  int face_count_ = 0;
  bool has_weights_ = false;
  bool has_extra_columns_ = false;
};

std::string_view OffReader::next_word() {
  std::string_view word = scanner_.next_word();
  if (word.empty() && layout_ == Layout::Free && scanner_.next_line()) word = scanner_.next_word();
  return word;
}

/// Read the header, if there is one, and return the first word after it. Some files have no blank
/// after OFF.
std::string_view OffReader::read_header() {
  const std::string_view word = scanner_.next_word();
  const std::size_t off = word.find("OFF");
  if (off == word.npos) return word;
  read_prefix(word.substr(0, off), word);
  std::string_view first = word.substr(off + 3);
  if (first.empty()) first = scanner_.next_word();
  if (first == "BINARY") scanner_.fail("binary OFF files are not read");
  if (!first.empty()) return first;
  if (!scanner_.next_line()) scanner_.fail("the file ends before the counts");
  return scanner_.next_word();
}

/// What stands before OFF: texture coordinates, colours, normals, a fourth coordinate.
void OffReader::read_prefix(std::string_view prefix, std::string_view word) {
  const auto take = [&prefix](std::string_view part) {
    const bool is_there = prefix.starts_with(part);
    if (is_there) prefix.remove_prefix(part.size());
    return is_there;
  };
  if (take("ST")) has_extra_columns_ = true;
  while (take("C") || take("N")) has_extra_columns_ = true;
  has_weights_ = take("4");
  if (prefix.empty()) return;
  scanner_.fail(fmt::format("the header {} is none of OFF, STOFF, COFF, NOFF, 4OFF", quoted(word)));
}

void OffReader::read_counts(std::string_view first) {
  vertex_count_ = scanner_.to_integer(first, "the count of vertices");
  face_count_ = scanner_.to_integer(scanner_.next_word(), "the count of faces");
  if (vertex_count_ < 0 || face_count_ < 0) scanner_.fail("a count is negative");
  if (layout_ == Layout::Free) {
    scanner_.to_integer(scanner_.next_word(), "the count of edges");
  }
}

/// Counts may lie: room is made for no more lines than the text can hold.
std::size_t OffReader::likely(int count) const {
  return std::min(static_cast<std::size_t>(count), text_size_ / 6 + 1);
}

void OffReader::next_element(std::string_view what, int done, int count) {
  if (layout_ == Layout::Free || scanner_.next_line()) return;
  scanner_.fail(fmt::format("the file ends after {} of {} {}", done, count, what));
}

Vec3 OffReader::read_point() {
  if (layout_ == Layout::Lines) return scanner_.next_point();
  Vec3 point;
  for (int k = 0; k < 3; ++k) point[k] = scanner_.to_number(next_word(), "a coordinate");
  return point;
}

void OffReader::read_vertices() {
  text_.cage.points.reserve(likely(vertex_count_));
  for (int i = 0; i < vertex_count_; ++i) {
    next_element("vertices", i, vertex_count_);
    Vec3 point = read_point();
    if (has_weights_) {
      point = text_.divided(point, scanner_.to_number(next_word(), "the weight of a vertex"));
    }
    text_.cage.points.push_back(point);
    if (layout_ == Layout::Lines && !has_extra_columns_) read_more_of_vertex();
  }
}

void OffReader::read_more_of_vertex() {
  const std::string_view extra = scanner_.next_word();
  if (extra.empty()) return;
  scanner_.to_number(extra, "a value after the coordinates");
  text_.warnings.add(scanner_.line(), "values after the coordinates are ignored");
}

void OffReader::read_faces() {
  text_.cage.faces.reserve(likely(face_count_));
  std::vector<int> corners;
  for (int i = 0; i < face_count_; ++i) {
    next_element("faces", i, face_count_);
    const int count = scanner_.to_integer(next_word(), "the vertex count of a face");
    if (count < 0) scanner_.fail("the vertex count of a face is negative");
    read_corners(count, corners);
    text_.add_face(corners);
  }
}

void OffReader::read_corners(int count, std::vector<int>& corners) {
  corners.clear();
  for (int k = 0; k < count; ++k) {
    const std::string_view word = next_word();
    if (word.empty()) scanner_.fail(fmt::format("a face has {} of {} vertices", k, count));
    const int vertex = scanner_.to_integer(word, "a vertex index");
    if (vertex < 0 || vertex >= vertex_count_) {
      scanner_.fail(fmt::format("vertex index {} is not in 0 to {}", vertex, vertex_count_ - 1));
    }
    corners.push_back(vertex);
  }
}

void OffReader::read_end() {
  if (layout_ == Layout::Free && !next_word().empty()) scanner_.fail("there are more values");
  if (!scanner_.next_line()) return;
  text_.warnings.add(scanner_.line(), "the lines after the last face are ignored");
}

/// Nearly all files have a line for each vertex and face. In the others every value counts, so a
/// file with a fault cannot be taken for one of them.
///
/// Returns  what `take` makes of a reader
template <class Take>
auto read_off(std::string_view text, const std::string& name, ReadFor purpose, Take take) {
  try {
    return take(OffReader(text, name, purpose, Layout::Lines));
  } catch (const Error&) {
    const std::exception_ptr fault = std::current_exception();
    try {
      return take(OffReader(text, name, purpose, Layout::Free));
    } catch (const Error&) {
      std::rethrow_exception(fault);
    }
  }
}

MeshArraysFile parse_off_mesh(std::string text, const std::string& name) {
  return read_off(text, name, ReadFor::Mesh, [](OffReader reader) {
    MeshArraysFile file = arrays_of(reader.read());
    file.degenerate_faces = reader.left_out();
    return file;
  });
}

void write_off(const PolyMesh& mesh, const MeshNames&, const OutputOptions&, OutputFile& file) {
  FileWriter writer(file);
  writer.text("OFF");
  const SharedVertices vertices(mesh);
  writer.number('\n', vertices.count());
  writer.number(' ', mesh.n_faces());
  writer.text(" 0");
  write_points(mesh, "", writer);
  writer.pieces(mesh.n_faces(), [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
    for (std::size_t f = first; f < end; ++f) {
      const FaceHandle fh(static_cast<int>(f));
      buffer.number('\n', mesh.valence(fh));
      for_each_vertex_of(mesh, fh,
                         [&](int vertex) { buffer.number(' ', vertices.number(vertex)); });
    }
  });
  writer.text("\n");
  writer.flush();
}

std::vector<std::string> lost_in_off(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  return lost_patches_and_properties(mesh, names);
}

}  // namespace

Cage parse_off(std::string_view text, const std::string& name) {
  return read_off(text, name, ReadFor::Cage, [](OffReader reader) { return reader.read(); });
}

MeshFormat off_format() {
  return {.ending = ".off",
          .parse = parse_off_mesh,
          .parse_cage = parse_off,
          .write = write_off,
          .what_is_lost = lost_in_off};
}

}  // namespace surfmesh
