// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/cad_number.hh"

namespace surfmesh {

[[noreturn]] inline void fail_brep(const std::string& reason) {
  throw Error(ErrorCode::InvalidInput, fmt::format("the BREP file is damaged: {}", reason));
}

/// Reads a text word by word.
class BrepWords {
 public:
  explicit BrepWords(std::string_view text, std::size_t position = 0)
      : text_(text), position_(position) {}

  /// Throws   InvalidInput at the end of the text, as all that follows
  std::string_view word() {
    constexpr std::string_view space = " \t\r\n";
    const std::size_t begin = text_.find_first_not_of(space, position_);
    if (begin == std::string_view::npos) fail_brep("it is cut off");
    position_ = std::min(text_.find_first_of(space, begin), text_.size());
    return text_.substr(begin, position_ - begin);
  }

  void skip(int words) {
    for (int i = 0; i < words; ++i) word();
  }

  int integer() { return integer(word()); }

  static int integer(std::string_view text) {
    int value = 0;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size()) {
      fail_brep(fmt::format("{} is no whole number", text));
    }
    return value;
  }

  /// A count, or a degree.
  int count(int least, int most) {
    const int value = integer();
    if (value < least || value > most) fail_brep(fmt::format("{} is no possible number", value));
    return value;
  }

  /// Numbers of any kind.
  void reals(int count) {
    for (int i = 0; i < count; ++i) {
      const std::string_view text = word();
      const auto value = cad_number(text);
      if (!value) fail_brep(fmt::format("{} is no number", text));
      if (is_too_large(*value)) fail_brep(fmt::format("{} is too large", text));
    }
  }

 private:
  std::string_view text_;
  std::size_t position_;
};

}  // namespace surfmesh
