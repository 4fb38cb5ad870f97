// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/partition.hh"

#include <algorithm>
#include <numeric>

namespace surfmesh {

std::vector<int> deal_in_runs(const std::vector<double>& weights, int pieces) {
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<int> piece_of;
  double before = 0;
  for (const double weight : weights) {
    const double middle = before + 0.5 * weight;
    const double share = all > 0 ? middle / all : 0;
    piece_of.push_back(std::min(pieces - 1, static_cast<int>(share * pieces)));
    before += weight;
  }
  return piece_of;
}

}  // namespace surfmesh
