// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <memory>
#include <string_view>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// Collects text and numbers and writes them to a file in large blocks.
class FileWriter {
 public:
  explicit FileWriter(OutputFile& file) : file_(file) {}

  void text(std::string_view text) {
    if (text.size() > kBufferSize - size_) flush();
    if (text.size() > kBufferSize) return file_.write(text);
    std::copy(text.begin(), text.end(), buffer_.get() + size_);
    size_ += text.size();
  }

  /// The shortest digits that read back as the same number, with a character before them.
  template <class Number>
  void number(char before, Number value) {
    if (kBufferSize - size_ < kLongestNumber) flush();
    buffer_[size_++] = before;
    char* begin = buffer_.get() + size_;
    size_ +=
        static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
  }

  /// The bytes of a number, the least significant first.
  template <class Number>
  void bytes(Number value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
    text({raw.data(), raw.size()});
  }

  /// The bytes of a number, the most significant first.
  template <class Number>
  void big_endian(Number value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::little) std::reverse(raw.begin(), raw.end());
    text({raw.data(), raw.size()});
  }

  void flush() {
    file_.write({buffer_.get(), size_});
    size_ = 0;
  }

 private:
  /// More than the 24 characters of -2.2250738585072014e-308.
  static constexpr std::size_t kLongestNumber = 32;

  static constexpr std::size_t kBufferSize = std::size_t{1} << 18;

  OutputFile& file_;
  /// Not initialised: small files do not touch all of it.
  std::unique_ptr<char[]> buffer_ = std::make_unique_for_overwrite<char[]>(kBufferSize);
  std::size_t size_ = 0;
};

/// Throws   Geometry, naming the vertex, if its position is not finite
void check_finite(const OpenMesh::Vec3d& point, VertexHandle vh);

/// Write the positions of all vertices but copies (shared_vertices.hh). Each starts a new line,
/// with a word in front ("v") or none.
///
/// Throws   Geometry for a position that is not finite
void write_points(const PolyMesh& mesh, std::string_view first_word, FileWriter& writer);

}  // namespace surfmesh
