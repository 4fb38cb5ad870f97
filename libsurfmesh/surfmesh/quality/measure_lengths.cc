// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/measure_lengths.hh"

#include <algorithm>
#include <limits>

#include "surfmesh/core/range_sums.hh"

namespace surfmesh::detail {
namespace {

struct Sums {
  Moments moments;
  double min = std::numeric_limits<double>::infinity();
  double max = 0;

  void add(double length) {
    moments.add(length);
    min = std::min(min, length);
    max = std::max(max, length);
  }

  Sums& operator+=(const Sums& other) {
    moments += other.moments;
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    return *this;
  }
};

}  // namespace

SpaceLengths measure_lengths(const PolyMesh& mesh) {
  if (mesh.n_edges() == 0) return {};
  const Sums sums = sum_of_ranges(mesh.n_edges(), [&](std::size_t first, std::size_t end) {
    Sums own;
    for (std::size_t e = first; e < end; ++e) {
      own.add(mesh.calc_edge_length(EdgeHandle(static_cast<int>(e))));
    }
    return own;
  });
  return {sums.moments, sums.min, sums.max};
}

}  // namespace surfmesh::detail
