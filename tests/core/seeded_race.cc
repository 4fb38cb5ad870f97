// SPDX-License-Identifier: BSD-3-Clause
// Counts without a lock: the thread sanitizer has to see that, or what it says of the rest is worth
// nothing.
#include <cstdio>

#include "surfmesh/core/parallel.hh"

int main() {
  std::size_t count = 0;
  surfmesh::with_threads(3, [&] { surfmesh::share_indices(10000, [&](std::size_t) { ++count; }); });
  std::printf("%zu\n", count);
  return 0;
}
