// SPDX-License-Identifier: BSD-3-Clause
// In place of threads.cc where the thread sanitizer judges: Debian's oneTBB is not built with it,
// so that it sees neither how work is handed out there nor how it is waited for, and takes all that
// threads share for a race.
#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "surfmesh/core/threads.hh"

namespace surfmesh::detail {
namespace {

int core_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

thread_local int limit = core_count();

}  // namespace

int thread_limit() { return limit; }

void with_thread_limit(int threads, const std::function<void()>& body) {
  struct Restored {
    int before;
    ~Restored() { limit = before; }
  };
  const Restored restored{std::exchange(limit, threads == 0 ? core_count() : threads)};
  body();
}

void run_at_once(int threads, const std::function<void()>& body) {
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(body);
  body();
}

}  // namespace surfmesh::detail
