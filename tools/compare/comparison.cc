// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison.hh"

#include <algorithm>

#include "pictures/median.hh"

namespace surfmesh::compare {

std::optional<Spread> ratio(const std::vector<double>& of, const std::vector<double>& to) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(of.size(), to.size()); ++round) {
    if (to[round] > 0) ratios.push_back(of[round] / to[round]);
  }
  if (ratios.empty()) return std::nullopt;
  const auto [least, greatest] = std::minmax_element(ratios.begin(), ratios.end());
  return Spread{median(ratios), *least, *greatest};
}

std::optional<double> speed(std::size_t triangles, const std::vector<double>& seconds) {
  if (seconds.empty()) return std::nullopt;
  const double middle = median(seconds);
  if (!(middle > 0)) return std::nullopt;
  return static_cast<double>(triangles) / middle;
}

}  // namespace surfmesh::compare
