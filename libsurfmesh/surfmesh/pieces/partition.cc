// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/partition.hh"

#include <algorithm>
#include <cstddef>

namespace surfmesh {
namespace {

/// Halvings of the range in which the least weight of the heaviest run lies: to all digits.
constexpr int kHalvings = 52;

/// The weights of all before each tile, and behind the last one that of all.
std::vector<double> sums_before(const std::vector<double>& weights) {
  std::vector<double> sums = {0};
  for (const double weight : weights) sums.push_back(sums.back() + weight);
  return sums;
}

/// By tile, in how many runs of at most `limit` each it and all behind it can be dealt; a tile
/// that weighs more is a run.
std::vector<std::size_t> runs_needed(const std::vector<double>& sums, double limit) {
  std::vector<std::size_t> needed(sums.size(), 0);
  std::size_t end = sums.size() - 1;
  for (std::size_t first = end; first-- > 0;) {
    while (end > first + 1 && sums[end] - sums[first] > limit) --end;
    needed[first] = needed[end] + 1;
  }
  return needed;
}

/// The least limit of runs with which there are few enough of them.
double least_limit(const std::vector<double>& weights, const std::vector<double>& sums,
                   std::size_t runs) {
  double low = std::max(*std::max_element(weights.begin(), weights.end()),
                        sums.back() / static_cast<double>(runs));
  if (runs_needed(sums, low).front() <= runs) return low;
  double high = sums.back();
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = low + (high - low) / 2;
    (runs_needed(sums, middle).front() <= runs ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::vector<int> deal_in_runs(const std::vector<double>& weights, int pieces) {
  const std::size_t count = weights.size();
  const std::size_t runs = std::min(count, static_cast<std::size_t>(pieces));
  if (runs == 0) return {};
  const std::vector<double> sums = sums_before(weights);
  const double limit = least_limit(weights, sums, runs);
  const std::vector<std::size_t> needed = runs_needed(sums, limit);
  std::vector<int> piece_of;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t first = piece_of.size(), runs_behind = runs - 1 - run;
    const double share = (sums.back() - sums[first]) / static_cast<double>(runs_behind + 1);
    std::size_t end = first + 1;
    // All behind must fit into the runs behind, and each of these needs a tile.
    const auto goes_on = [&] {
      if (needed[end] > runs_behind) return true;
      return (sums[end] + sums[end + 1]) / 2 - sums[first] <= share &&
             sums[end + 1] - sums[first] <= limit;
    };
    while (end < count - runs_behind && goes_on()) ++end;
    piece_of.resize(end, static_cast<int>(run));
  }
  return piece_of;
}

}  // namespace surfmesh
