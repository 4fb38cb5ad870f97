// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace surfmesh {

/// DisjointSets that threads unite at the same time. How many unions join two sets does not depend
/// on their order.
///
/// Cost     nearly constant for each call
class SharedSets {
 public:
  explicit SharedSets(std::size_t count) : parents_(count) {
    for (std::size_t i = 0; i < count; ++i) parents_[i].store(i, std::memory_order_relaxed);
  }

  /// Make one set of those of i and j.
  /// Returns  true if they were apart
  bool unite(std::size_t i, std::size_t j) {
    for (;;) {
      i = find(i);
      j = find(j);
      if (i == j) return false;
      std::size_t greater = std::max(i, j);
      // Unless another thread has given it a parent meanwhile.
      if (parents_[greater].compare_exchange_strong(greater, std::min(i, j),
                                                    std::memory_order_relaxed)) {
        return true;
      }
    }
  }

  /// The least number of the set of i so far.
  std::size_t find(std::size_t i) {
    for (;;) {
      const std::size_t parent = parents_[i].load(std::memory_order_relaxed);
      if (parent == i) return i;
      const std::size_t next = parents_[parent].load(std::memory_order_relaxed);
      // What another thread has written here meanwhile is in the same set, as this is.
      parents_[i].store(next, std::memory_order_relaxed);
      i = next;
    }
  }

 private:
  std::vector<std::atomic<std::size_t>> parents_;
};

}  // namespace surfmesh
