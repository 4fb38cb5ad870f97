// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Text and numbers one after the other in memory, which grows with them.
class TextBuffer {
 public:
  void text(std::string_view text) {
    make_room(text.size());
    std::copy(text.begin(), text.end(), memory_.get() + size_);
    size_ += text.size();
  }

  /// The shortest digits that read back as the same number, with a character before them.
  template <class Number>
  void number(char before, Number value) {
    make_room(kLongestNumber + 1);
    memory_[size_++] = before;
    char* const begin = memory_.get() + size_;
    size_ +=
        static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
  }

  /// The bytes of a number, the least significant first.
  template <class Number>
  void bytes(Number value) {
    ordered_bytes(value, std::endian::little);
  }

  /// The bytes of a number, the most significant first.
  template <class Number>
  void big_endian(Number value) {
    ordered_bytes(value, std::endian::big);
  }

  std::size_t size() const { return size_; }
  std::string_view text() const { return {memory_.get(), size_}; }

  /// Forget the text, but keep the memory.
  void clear() { size_ = 0; }

 private:
  /// More than the 24 characters of -2.2250738585072014e-308.
  static constexpr std::size_t kLongestNumber = 32;

  template <class Number>
  void ordered_bytes(Number value, std::endian order) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if (std::endian::native != order) std::reverse(raw.begin(), raw.end());
    make_room(raw.size());
    std::copy(raw.begin(), raw.end(), memory_.get() + size_);
    size_ += raw.size();
  }

  void make_room(std::size_t size) {
    if (capacity_ - size_ < size) grow(size);
  }

  void grow(std::size_t size) {
    capacity_ = std::max({std::size_t{1} << 12, 2 * capacity_, size_ + size});
    // Not initialised: what is not used is not touched.
    auto memory = std::make_unique_for_overwrite<char[]>(capacity_);
    std::copy_n(memory_.get(), size_, memory.get());
    memory_ = std::move(memory);
  }

  std::unique_ptr<char[]> memory_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace surfmesh
