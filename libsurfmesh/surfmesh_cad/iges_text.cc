// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/iges_text.hh"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/cad_number.hh"

namespace surfmesh {
namespace {

/// The column that tells the section of a line, from 0.
constexpr std::size_t kSectionColumn = 72;

/// Values of entities stand in so many columns. No number goes on in the next line.
constexpr std::size_t kValueColumns = 64;

/// A number as IGES has it: the exponents of double precision have the letter D.
std::optional<double> iges_number(std::string_view text) {
  std::string number(text);
  std::replace_if(
      number.begin(), number.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  return cad_number(number);
}

/// Goes through the values of the entities, line by line.
class IgesValues {
 public:
  /// The global section begins with the characters behind a value and behind the last one, "1H,"
  /// and "1H;", if they are not these.
  void read_delimiters(std::string_view global) {
    if (!global.starts_with("1H") || global.size() < 4) return;
    delimiter_ = global[2];
    if (global.substr(4).starts_with("1H") && global.size() > 6) last_ = global[6];
  }

  void check(std::string_view columns, std::size_t line) {
    while (!columns.empty()) {
      if (text_left_ > 0) {
        const std::size_t count = std::min(text_left_, columns.size());
        columns.remove_prefix(count);
        text_left_ -= count;
      } else if (!take_text(columns)) {
        const std::size_t end = std::min(end_of_value(columns), columns.size());
        check_number(columns.substr(0, end), line);
        // Behind the last value of an entity there may be a comment.
        if (end == columns.size() || columns[end] == last_) return;
        columns.remove_prefix(end + 1);
      }
    }
  }

 private:
  std::size_t end_of_value(std::string_view columns) const {
    return std::min(columns.find(delimiter_), columns.find(last_));
  }

  /// A text is its length, H, and so many characters, which may be any, also in lines to come.
  bool take_text(std::string_view& columns) {
    columns.remove_prefix(std::min(columns.find_first_not_of(' '), columns.size()));
    std::size_t length = 0;
    const auto [stop, error] =
        std::from_chars(columns.data(), columns.data() + columns.size(), length);
    const auto digits = static_cast<std::size_t>(stop - columns.data());
    if (error != std::errc() || !columns.substr(digits).starts_with('H')) return false;
    columns.remove_prefix(digits + 1);
    text_left_ = length;
    return true;
  }

  static void check_number(std::string_view value, std::size_t line) {
    value = value.substr(0, value.find(' '));
    if (!is_too_large(iges_number(value).value_or(0))) return;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the IGES file is damaged: line {}: {} is too large", line, value));
  }

  char delimiter_ = ',';
  char last_ = ';';
  std::size_t text_left_ = 0;  ///< characters of a text that are still to come
};

}  // namespace

char section_of(std::string_view line) {
  return line.size() > kSectionColumn ? line[kSectionColumn] : '\0';
}

void check_iges_text(std::string_view text) {
  IgesValues values;
  bool is_first = true;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view columns = text.substr(0, end);
    const char section = section_of(columns);
    if (section == 'G' && is_first) values.read_delimiters(columns);
    is_first = is_first && section != 'G';
    if (section == 'P') values.check(columns.substr(0, kValueColumns), line);
    const bool is_pair = text.substr(end).starts_with("\r\n");
    text.remove_prefix(std::min(end + (is_pair ? 2 : 1), text.size()));
  }
}

}  // namespace surfmesh
