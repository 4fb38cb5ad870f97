// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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

  /// Cost     about 1 ns a byte, shared among threads
  void add(std::span<const std::byte> bytes) {
    const std::size_t begun = rest_size_ == 0 ? 0 : std::min(3 - rest_size_, bytes.size());
    for (const std::byte byte : bytes.first(begun)) add_byte(byte);
    bytes = bytes.subspan(begun);
    writer_.pieces(bytes.size() / 3, [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
      for (std::size_t i = first; i < end; ++i) {
        const Letters letters = letters_of(bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]);
        buffer.text({letters.data(), letters.size()});
      }
    });
    for (const std::byte byte : bytes.last(bytes.size() % 3)) add_byte(byte);
  }

  /// End what was added, with = up to four characters.
  void finish() {
    if (rest_size_ == 0) return;
    const std::size_t missing = 3 - rest_size_;
    for (std::size_t i = rest_size_; i < 3; ++i) rest_[i] = std::byte{0};
    const Letters letters = letters_of(rest_[0], rest_[1], rest_[2]);
    writer_.text({letters.data(), letters.size() - missing});
    writer_.text(std::string_view("==").substr(0, missing));
    rest_size_ = 0;
  }

 private:
  using Letters = std::array<char, 4>;

  void add_byte(std::byte byte) {
    rest_[rest_size_++] = byte;
    if (rest_size_ < rest_.size()) return;
    rest_size_ = 0;
    const Letters letters = letters_of(rest_[0], rest_[1], rest_[2]);
    writer_.text({letters.data(), letters.size()});
  }

  static Letters letters_of(std::byte a, std::byte b, std::byte c) {
    static constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::uint32_t bits = std::to_integer<std::uint32_t>(a) << 16U |
                               std::to_integer<std::uint32_t>(b) << 8U |
                               std::to_integer<std::uint32_t>(c);
    return {kLetters[bits >> 18U], kLetters[bits >> 12U & 63U], kLetters[bits >> 6U & 63U],
            kLetters[bits & 63U]};
  }

  FileWriter& writer_;
  std::array<std::byte, 3> rest_ = {};  ///< that have no letters yet
  std::size_t rest_size_ = 0;
};

}  // namespace surfmesh
