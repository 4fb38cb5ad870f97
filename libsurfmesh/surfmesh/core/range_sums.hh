// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

#include "surfmesh/core/parallel.hh"

namespace surfmesh {

/// The sum, by +=, of what `part(first, end)` makes of ranges of the indices below `count`, in the
/// order of the ranges: it is the same to the last bit for any number of threads.
///
/// Throws   the error of the first range that fails
template <class Part>
auto sum_of_ranges(std::size_t count, Part part) {
  using Sum = decltype(part(std::size_t{0}, std::size_t{0}));
  std::map<std::size_t, Sum> by_first;
  std::mutex mutex;
  share_ranges(count, [&](std::size_t first, std::size_t end) {
    Sum own = part(first, end);
    const std::lock_guard lock(mutex);
    by_first.emplace(first, std::move(own));
  });
  Sum sum{};
  for (const auto& [first, own] : by_first) sum += own;
  return sum;
}

}  // namespace surfmesh
