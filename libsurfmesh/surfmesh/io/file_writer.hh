// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/io/text_buffer.hh"

namespace surfmesh {

/// Collects text and numbers and writes them to a file in large blocks.
class FileWriter {
 public:
  /// Indices of a piece of pieces(), but for the last one.
  static constexpr std::size_t kPiece = 4096;

  explicit FileWriter(OutputFile& file) : file_(file) {}

  void text(std::string_view text) {
    if (text.size() > kBlock) {
      flush();
      return file_.write(text);
    }
    buffer_.text(text);
    flush_block();
  }

  /// As those of TextBuffer.
  template <class Number>
  void number(char before, Number value) {
    buffer_.number(before, value);
    flush_block();
  }

  template <class Number>
  void bytes(Number value) {
    buffer_.bytes(value);
    flush_block();
  }

  template <class Number>
  void big_endian(Number value) {
    buffer_.big_endian(value);
    flush_block();
  }

  /// Write what `format(first, end, buffer)` adds to a buffer for pieces of the indices below
  /// `count`, piece after piece. Threads share the pieces, some of which are held in memory at a
  /// time.
  ///
  /// Throws   the error of the first piece that fails
  void pieces(std::size_t count,
              const std::function<void(std::size_t, std::size_t, TextBuffer&)>& format);

  void flush() {
    file_.write(buffer_.text());
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 18;

  void flush_block() {
    if (buffer_.size() >= kBlock) flush();
  }

  OutputFile& file_;
  TextBuffer buffer_;
};

/// Throws   Geometry, naming the vertex, if its position is not finite
void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh);

/// Write the positions of all vertices but copies (shared_vertices.hh). Each starts a new line,
/// with a word in front ("v") or none.
///
/// Throws   Geometry for a position that is not finite
void write_points(const PolyMesh& mesh, std::string_view first_word, FileWriter& writer);

}  // namespace surfmesh
