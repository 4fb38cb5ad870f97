// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

namespace surfmesh {

/// A side of a face of a cage, by its vertices.
struct CageSide {
  int low = -1;
  int high = -1;
  int face = -1;
  bool is_rising = false;  ///< the face passes it from the lower to the higher vertex
};

/// The sides of faces, sorted by their vertices and then by the face. Those that are points are
/// left out.
///
/// Pre      vertices are not negative
/// Cost     O(n) for n sides, and for the greatest vertex
std::vector<CageSide> sorted_sides(const std::vector<std::vector<int>>& faces);

/// Call `visit` for each edge with its sides, at least one.
template <class Visit>
void for_each_edge(std::span<const CageSide> sides, Visit visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t end = first + 1;
    while (end < sides.size() && sides[end].low == sides[first].low &&
           sides[end].high == sides[first].high) {
      ++end;
    }
    visit(sides.subspan(first, end - first));
    first = end;
  }
}

}  // namespace surfmesh
