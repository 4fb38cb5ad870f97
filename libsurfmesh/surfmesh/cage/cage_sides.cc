// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_sides.hh"

#include <algorithm>
#include <tuple>

namespace surfmesh {

std::vector<CageSide> sorted_sides(const std::vector<std::vector<int>>& faces) {
  std::vector<CageSide> sides;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& face = faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[i + 1 == face.size() ? 0 : i + 1];
      if (from == to) continue;
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(f), from < to});
    }
  }
  const auto key = [](const CageSide& side) { return std::tuple(side.low, side.high, side.face); };
  std::sort(sides.begin(), sides.end(),
            [&](const CageSide& a, const CageSide& b) { return key(a) < key(b); });
  return sides;
}

}  // namespace surfmesh
