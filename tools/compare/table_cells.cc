// SPDX-License-Identifier: BSD-3-Clause
#include "compare/table_cells.hh"

#include <fmt/format.h>

#include "pictures/median.hh"

namespace surfmesh::compare {

std::string with_commas(std::size_t number) {
  if (number < 1000) return std::to_string(number);
  return fmt::format("{},{:03}", with_commas(number / 1000), number % 1000);
}

std::string seconds_text(const std::vector<double>& seconds) {
  return seconds.empty() ? kNone : fmt::format("{:.3g}", median(seconds));
}

std::string spread_text(const std::optional<Spread>& spread) {
  if (!spread) return kNone;
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", spread->median, spread->least, spread->greatest);
}

}  // namespace surfmesh::compare
