// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "surfmesh/io/file_writer.hh"

namespace surfmesh {

/// The size of so many bytes as base64.
constexpr std::size_t base64_size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

/// Writes bytes as base64 text (RFC 4648), for XML files.
class Base64Writer {
 public:
  explicit Base64Writer(FileWriter& writer) : writer_(writer) {}

  /// Cost     about 1 ns a byte
  void add(std::span<const std::byte> bytes) {
    std::size_t i = 0;
    while (rest_size_ > 0 && i < bytes.size()) add_byte(bytes[i++]);
    for (; i + 3 <= bytes.size(); i += 3) put(bytes[i], bytes[i + 1], bytes[i + 2]);
    while (i < bytes.size()) add_byte(bytes[i++]);
  }

  /// End what was added, with = up to four characters.
  void finish() {
    const std::size_t missing = rest_size_ == 0 ? 0 : 3 - rest_size_;
    for (std::size_t i = 0; i < missing; ++i) add_byte(std::byte{0});
    writer_.text({text_.data(), size_ - missing});
    writer_.text(std::string_view("==").substr(0, missing));
    size_ = 0;
  }

 private:
  void add_byte(std::byte byte) {
    rest_[rest_size_++] = byte;
    if (rest_size_ < rest_.size()) return;
    rest_size_ = 0;
    put(rest_[0], rest_[1], rest_[2]);
  }

  void put(std::byte a, std::byte b, std::byte c) {
    static constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::uint32_t bits = std::to_integer<std::uint32_t>(a) << 16U |
                               std::to_integer<std::uint32_t>(b) << 8U |
                               std::to_integer<std::uint32_t>(c);
    if (size_ == text_.size()) {
      writer_.text({text_.data(), size_});
      size_ = 0;
    }
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text_[size_++] = kLetters[bits >> shift & 63U];
  }

  FileWriter& writer_;
  std::array<char, 4096> text_;
  std::size_t size_ = 0;
  std::array<std::byte, 3> rest_ = {};
  std::size_t rest_size_ = 0;
};

}  // namespace surfmesh
