// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_sides.hh"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// Call `visit` for the sides of faces but those that are points.
template <class Visit>
void for_each_side(const std::vector<std::vector<int>>& faces, Visit visit) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& face = faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[i + 1 == face.size() ? 0 : i + 1];
      if (from == to) continue;
      visit(CageSide{std::min(from, to), std::max(from, to), static_cast<int>(f), from < to});
    }
  }
}

/// For each vertex, where its sides begin that have it as the lower end; the number of all sides at
/// the end.
std::vector<std::size_t> first_sides(const std::vector<std::vector<int>>& faces) {
  std::vector<std::size_t> first(2, 0);
  for_each_side(faces, [&](const CageSide& side) {
    const auto next = static_cast<std::size_t>(side.low) + 1;
    if (next >= first.size()) first.resize(next + 1, 0);
    ++first[next];
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

}  // namespace

std::vector<CageSide> sorted_sides(const std::vector<std::vector<int>>& faces) {
  const std::vector<std::size_t> first = first_sides(faces);
  std::vector<CageSide> sides(first.back());
  std::vector<std::size_t> next = first;
  for_each_side(faces, [&](const CageSide& side) {
    sides[next[static_cast<std::size_t>(side.low)]++] = side;
  });
  const auto key = [](const CageSide& side) { return std::tuple(side.high, side.face); };
  share_ranges(first.size() - 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::sort(sides.begin() + static_cast<std::ptrdiff_t>(first[v]),
                sides.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
                [&](const CageSide& a, const CageSide& b) { return key(a) < key(b); });
    }
  });
  return sides;
}

}  // namespace surfmesh
