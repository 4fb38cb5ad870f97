// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace surfmesh {

/// Sets of the numbers 0 … count − 1, which grow by union; at first each number is a set of its
/// own.
///
/// Cost     nearly constant for each call
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  /// The number that represents the set of i: the least one in it.
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  /// Make one set of those of i and j.
  /// Returns  true if they were apart
  bool unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    parents_[std::max(i, j)] = std::min(i, j);
    return true;
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace surfmesh
