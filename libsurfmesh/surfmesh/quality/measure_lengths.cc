// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/measure_lengths.hh"

#include <algorithm>
#include <limits>

#include "surfmesh/core/range_sums.hh"

namespace surfmesh::detail {
namespace {

struct Sums {
  double min = std::numeric_limits<double>::infinity();
  double max = 0;
  double sum = 0;

  void add(double length) { *this += {length, length, length}; }

  Sums& operator+=(const Sums& other) {
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    sum += other.sum;
    return *this;
  }
};

}  // namespace

SpaceLengths measure_lengths(const PolyMesh& mesh) {
  const std::size_t count = mesh.n_edges();
  if (count == 0) return {};
  const Sums sums = sum_of_ranges(count, [&](std::size_t first, std::size_t end) {
    Sums own;
    for (std::size_t e = first; e < end; ++e) {
      own.add(mesh.calc_edge_length(EdgeHandle(static_cast<int>(e))));
    }
    return own;
  });
  return {count, sums.min, sums.sum / static_cast<double>(count), sums.max};
}

}  // namespace surfmesh::detail
