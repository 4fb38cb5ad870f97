// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/parts.hh"

#include <algorithm>
#include <cmath>

namespace surfmesh {

std::vector<double> even_breaks(int count) {
  std::vector<double> breaks;
  for (int i = 1; i < count; ++i) breaks.push_back(static_cast<double>(i) / count);
  return breaks;
}

std::vector<double> divided_parts(const std::vector<double>& breaks, int count) {
  std::vector<double> divided = {0};
  const auto add_part = [&](double end) {
    const double start = divided.back();
    for (int i = 1; i < count; ++i) {
      divided.push_back(std::lerp(start, end, static_cast<double>(i) / count));
    }
    divided.push_back(end);
  };
  for (const double end : breaks) add_part(end);
  add_part(1);
  return divided;
}

double part_width(const std::vector<double>& breaks, double t) {
  const auto end = std::upper_bound(breaks.begin(), breaks.end(), t);
  const double from = end == breaks.begin() ? 0 : *(end - 1);
  return (end == breaks.end() ? 1 : *end) - from;
}

std::vector<double> breaks_between(const std::vector<double>& breaks, double from, double to) {
  std::vector<double> result;
  for (const double t : breaks) {
    if (t > std::min(from, to) && t < std::max(from, to))
      result.push_back((t - from) / (to - from));
  }
  if (to < from) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace surfmesh
