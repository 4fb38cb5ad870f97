// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// More threads than these only stand in each other's way.
inline constexpr int kMostThreads = 256;

/// Call `body`, in which so many threads work where work is shared; 0 is one for each core. With 1
/// no thread is started.
/// Pre      threads is from 0 to kMostThreads
void with_threads(int threads, const std::function<void()>& body);

/// Call `body(index)` for each of the indices, which are those below their number in any order; on
/// the threads of with_threads, outside of it on all cores.
///
/// Calls are begun in the order of `indices`: what takes longest is best the first. A call within a
/// call is not shared further.
///
/// Throws   what the least index of those that fail throws; after a failure greater indices may be
///          left out, so that the error does not depend on the number of threads
void share_indices(const std::vector<std::size_t>& indices,
                   const std::function<void(std::size_t)>& body);

/// The same for all indices below `count`, from 0 up.
void share_indices(std::size_t count, const std::function<void(std::size_t)>& body);

/// Call `body(first, end)` for parts of the indices below `count`. The parts do not depend on the
/// number of threads, so that what is summed up by parts does not either.
void share_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body);

/// The indices of weights, the greatest weight first, equal ones in their order.
std::vector<std::size_t> heaviest_first(const std::vector<std::size_t>& weights);

/// Processor time of this thread in seconds, with that of others in calls that it has shared.
double processor_seconds();

/// Adds the processor time of a scope to a number of seconds.
class StageClock {
 public:
  explicit StageClock(double& seconds) : seconds_(seconds), start_(processor_seconds()) {}
  ~StageClock() { seconds_ += processor_seconds() - start_; }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  double& seconds_;
  double start_;
};

}  // namespace surfmesh
