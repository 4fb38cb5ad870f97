// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "surfmesh/io/clean_text.hh"

/// The words of VTK's XML files.
namespace surfmesh::vtu {

/// What the type of a number is called.
template <class Number>
constexpr std::string_view kType = "";
template <>
inline constexpr std::string_view kType<double> = "Float64";
template <>
inline constexpr std::string_view kType<int> = "Int32";
template <>
inline constexpr std::string_view kType<std::int64_t> = "Int64";
template <>
inline constexpr std::string_view kType<std::uint32_t> = "UInt32";
template <>
inline constexpr std::string_view kType<std::uint8_t> = "UInt8";

/// A name as the value of an XML attribute.
inline std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : clean_text(name)) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '"') {
      text += "&quot;";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace surfmesh::vtu
