// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/uneven_cells.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace surfmesh {
namespace {

double from_index(const std::vector<double>& lines, double index) {
  const double last = static_cast<double>(lines.size()) - 2;
  const double cell = std::clamp(std::floor(index), 0.0, last);
  const auto i = static_cast<std::size_t>(cell);
  return std::lerp(lines[i], lines[i + 1], index - cell);
}

double to_index(const std::vector<double>& lines, double value) {
  const auto end = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
  const double from = *(end - 1);
  return static_cast<double>(end - 1 - lines.begin()) + (value - from) / (*end - from);
}

}  // namespace

Uv UnevenCells::from_cells(Uv cells) const {
  return {from_index(u, cells.u), from_index(v, cells.v)};
}

Uv UnevenCells::to_cells(Uv uv) const { return {to_index(u, uv.u), to_index(v, uv.v)}; }

}  // namespace surfmesh
