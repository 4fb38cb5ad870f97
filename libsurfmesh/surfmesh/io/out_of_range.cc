// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/out_of_range.hh"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>

namespace surfmesh {
namespace {

/// The exponent behind the letter; the greatest or least possible one beyond those.
long exponent_of(std::string_view digits) {
  if (digits.starts_with('+')) digits.remove_prefix(1);
  long value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc::result_out_of_range) return value;
  return digits.starts_with('-') ? std::numeric_limits<long>::min()
                                 : std::numeric_limits<long>::max();
}

}  // namespace

bool is_too_near_to_zero(std::string_view number) {
  const std::size_t letter = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, letter);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const auto first = static_cast<long>(std::min(digits.find_first_of("123456789"), digits.size()));
  // The power of ten of the first digit that is not 0, without the exponent.
  const long power = static_cast<long>(point) - first - (first < static_cast<long>(point) ? 1 : 0);
  const long exponent = letter < number.size() ? exponent_of(number.substr(letter + 1)) : 0;
  return exponent < -power;
}

}  // namespace surfmesh
