// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/threads.hh"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <optional>

namespace surfmesh::detail {

int thread_limit() { return tbb::this_task_arena::max_concurrency(); }

void with_thread_limit(int threads, const std::function<void()>& body) {
  const int cores = tbb::info::default_concurrency();
  if (threads == 0) threads = cores;
  std::optional<tbb::global_control> more_than_cores;
  if (threads > cores) {
    more_than_cores.emplace(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(threads));
  }
  tbb::task_arena(threads).execute(body);
}

void run_at_once(int threads, const std::function<void()>& body) {
  // A thread that waits for the last calls must not begin other work: its clock is running.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        0, threads, [&](int) { body(); }, tbb::simple_partitioner());
  });
}

}  // namespace surfmesh::detail
