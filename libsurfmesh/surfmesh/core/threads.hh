// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace surfmesh::detail {

/// The threads on which this one may run something at once, itself among them.
int thread_limit();

/// Run `body` with another limit, in any thread; 0 is one per core.
void with_thread_limit(int threads, const std::function<void()>& body);

/// Run `body` on so many threads at once, or fewer where others are busy, and wait for all.
///
/// Pre      threads is at most thread_limit(); `body` does not throw
void run_at_once(int threads, const std::function<void()>& body);

}  // namespace surfmesh::detail
