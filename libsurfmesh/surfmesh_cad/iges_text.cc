// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/iges_text.hh"

#include <fmt/format.h>

#include <algorithm>
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
  std::replace(number.begin(), number.end(), 'D', 'E');
  return cad_number(number);
}

void check_values(std::string_view values, std::size_t line) {
  while (!values.empty()) {
    const std::size_t end = std::min(values.find_first_of(",; \r"), values.size());
    const std::string_view value = values.substr(0, end);
    if (is_too_large(iges_number(value).value_or(0))) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("the IGES file is damaged: line {}: {} is too large", line, value));
    }
    values.remove_prefix(std::min(end + 1, values.size()));
  }
}

}  // namespace

char section_of(std::string_view line) {
  return line.size() > kSectionColumn ? line[kSectionColumn] : '\0';
}

void check_iges_text(std::string_view text) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view columns = text.substr(0, end);
    if (section_of(columns) == 'P') check_values(columns.substr(0, kValueColumns), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace surfmesh
