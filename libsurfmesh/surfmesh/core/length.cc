// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/length.hh"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"

namespace surfmesh {
namespace {

/// Exponents beyond this are out of the range of doubles whatever stands before them; it only
/// keeps their sum with 2 from overflowing.
constexpr int kLargestExponent = 100000;

template <class Number>
std::optional<Number> to_number(std::string_view text) {
  Number value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view without_blanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The text of a number times a power of ten: its exponent is changed, for a product of doubles
/// would be rounded. Empty if the exponent cannot be read.
std::string shift_exponent(std::string_view text, int by) {
  const std::size_t mark = text.find_first_of("eE");
  int exponent = 0;
  if (mark != text.npos) {
    std::string_view digits = text.substr(mark + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto read = to_number<int>(digits);
    if (!read || std::abs(*read) > kLargestExponent) return {};
    exponent = *read;
  }
  return fmt::format("{}e{}", text.substr(0, mark), exponent + by);
}

std::optional<double> read_percent(std::string_view text) {
  return to_number<double>(shift_exponent(text, -2));
}

std::string percent_text(double share) {
  std::array<char, 32> buffer{};  // more than the 24 characters of the longest double
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), share,
                                 std::chars_format::scientific);
  const std::string exact = shift_exponent({buffer.data(), end.ptr}, 2);
  const std::string plain = fmt::format("{}", to_number<double>(exact).value_or(share));
  return (read_percent(plain) == share ? plain : exact) + "%";
}

}  // namespace

bool Length::is_legal() const {
  return value >= 0 && std::isfinite(value) && !(is_relative && value > 1);
}

Length Length::percent(double value) {
  return std::isfinite(value) ? parse_length(fmt::format("{}%", value)) : share(value);
}

Length parse_length(std::string_view text) {
  std::string_view digits = without_blanks(text);
  const bool is_relative = digits.ends_with('%');
  if (is_relative) digits = without_blanks(digits.substr(0, digits.size() - 1));
  const auto value = is_relative ? read_percent(digits) : to_number<double>(digits);
  if (!value || !std::isfinite(*value)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("'{}' is no length: a number, or a share of the diagonal such as 0.1%",
                            text.substr(0, 40)));
  }
  return is_relative ? Length::share(*value) : Length::units(*value);
}

std::string to_text(const Length& length) {
  return length.is_relative ? percent_text(length.value) : fmt::format("{}", length.value);
}

bool LengthRange::contains(const std::optional<Length>& length) const {
  return length ? length->is_legal() && length->value > 0 : can_be_off;
}

std::string to_text(const LengthRange& range) {
  return fmt::format("{}{}a length above 0 in model units, or a share of the diagonal up to 100%",
                     range.can_be_off ? "off, " : "",
                     range.on > 0 ? fmt::format("on ({}), ", percent_text(range.on)) : "");
}

std::string to_text(const std::optional<Length>& length) {
  return length ? to_text(*length) : "off";
}

void check_option(const LengthRange& range, const std::optional<Length>& length) {
  if (!range.contains(length)) fail_option(range.name, to_text(length), to_text(range));
}

}  // namespace surfmesh
