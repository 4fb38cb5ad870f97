// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/clean_text.hh"

#include <array>
#include <cstddef>
#include <cstdint>

namespace surfmesh {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Characters of so many bytes: their first byte under a mask, and the least of them, for longer
/// forms of smaller ones are no UTF-8.
struct Form {
  std::size_t bytes;
  unsigned mask, lead;
  std::uint32_t least;
};

constexpr std::array kForms = {Form{1, 0x80, 0x00, 0x20}, Form{2, 0xE0, 0xC0, 0x80},
                               Form{3, 0xF0, 0xE0, 0x800}, Form{4, 0xF8, 0xF0, 0x10000}};

bool is_character(std::uint32_t code) {
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  return !is_surrogate && code != 0xFFFE && code != 0xFFFF && code <= 0x10FFFF;
}

/// The number of bytes of the character that a text begins with; 0 if it begins with none.
std::size_t first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned { return static_cast<unsigned char>(text[i]); };
  for (const Form& form : kForms) {
    if ((byte(0) & form.mask) != form.lead || text.size() < form.bytes) continue;
    std::uint32_t code = byte(0) & ~form.mask;
    for (std::size_t i = 1; i < form.bytes; ++i) {
      if ((byte(i) & 0xC0U) != 0x80U) return 0;
      code = code << 6U | (byte(i) & 0x3FU);
    }
    return code >= form.least && is_character(code) ? form.bytes : 0;
  }
  return 0;
}

}  // namespace

std::string clean_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t bytes = first_character(text);
    result += bytes > 0 ? text.substr(0, bytes) : kReplacement;
    text.remove_prefix(bytes > 0 ? bytes : 1);
  }
  return result;
}

}  // namespace surfmesh
