// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// Takes numbers from the bytes of a binary file, for the readers of such formats.
class ByteScanner {
 public:
  /// `bytes` are the whole file, of which the first `offset` are skipped; they must outlive the
  /// scanner. `name` stands in messages.
  ByteScanner(std::string_view bytes, std::size_t offset, std::string name,
              std::endian order = std::endian::little)
      : bytes_(bytes),
        offset_(offset),
        name_(std::move(name)),
        is_swapped_(order != std::endian::native) {}

  std::size_t offset() const { return offset_; }
  std::size_t rest() const { return bytes_.size() - offset_; }

  /// Throws   InvalidInput if the file ends before
  template <class Number>
  Number take() {
    if (rest() < sizeof(Number)) fail("the file ends here, it is cut short");
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + offset_, raw.size());
    if (is_swapped_) std::reverse(raw.begin(), raw.end());
    offset_ += raw.size();
    return std::bit_cast<Number>(raw);
  }

  /// Throws   InvalidInput if the file ends before
  void skip(std::size_t count) {
    if (rest() < count) fail("the file ends too early, it is cut short");
    offset_ += count;
  }

  /// Throw InvalidInput with "name: byte offset: reason".
  [[noreturn]] void fail(std::string_view reason) const { fail_at(offset_, reason); }
  [[noreturn]] void fail_at(std::size_t offset, std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: byte {}: {}", name_, offset, reason));
  }

  const std::string& name() const { return name_; }

 private:
  std::string_view bytes_;
  std::size_t offset_;
  std::string name_;
  bool is_swapped_;
};

}  // namespace surfmesh
