// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/cad_number.hh"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "surfmesh/io/out_of_range.hh"

namespace surfmesh {
namespace {

constexpr double kMostNumber = 1e101;

}  // namespace

std::optional<double> cad_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  // Those that begin otherwise are words: "inf", "nan".
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (text.find_first_of("0123456789.", first) != first) return {};
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (stop != text.data() + text.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc()) return value;
  return is_too_near_to_zero(text) ? 0 : std::numeric_limits<double>::infinity();
}

bool is_too_large(double number) { return std::abs(number) > kMostNumber; }

}  // namespace surfmesh
