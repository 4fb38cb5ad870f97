// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Greatest number of threads; more only get in each other's way.
inline constexpr int kMostThreads = 256;

/// Run `body` with up to `threads` threads; 0 means one per core. With 1, no thread is started, not
/// even where `body` asks for more.
/// Pre      threads is from 0 to kMostThreads
void with_threads(int threads, const std::function<void()>& body);

/// Call `body(index)` for each of the indices, a permutation of those below their number. Runs on
/// the threads of with_threads; outside of it, on all cores.
///
/// Calls start in the order of `indices`, so the longest ones should come first. A nested call is
/// not shared further.
///
/// Throws   the error of the lowest failing index, so that the error does not depend on the number
///          of threads. After a failure, higher indices may be skipped
void share_indices(const std::vector<std::size_t>& indices,
                   const std::function<void(std::size_t)>& body);

/// The same for all indices below `count`, from 0 up.
void share_indices(std::size_t count, const std::function<void(std::size_t)>& body);

/// Call `body(first, end)` for ranges of the indices below `count`. The ranges do not depend on the
/// number of threads, so neither do sums that are built range by range.
void share_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body);

/// The indices of the weights, greatest weight first; equal weights keep their order.
std::vector<std::size_t> heaviest_first(const std::vector<std::size_t>& weights);

/// Processor time of this thread in seconds, including that of other threads in calls that it has
/// shared.
double processor_seconds();

/// Of processor_seconds(), what this thread has spent outside of calls that share, and of scopes
/// that are left out: what more threads do not make shorter.
double serial_seconds();

/// Leaves a scope out of serial_seconds().
class LeftOutOfSerial {
 public:
  LeftOutOfSerial();
  ~LeftOutOfSerial();
  LeftOutOfSerial(const LeftOutOfSerial&) = delete;
  LeftOutOfSerial& operator=(const LeftOutOfSerial&) = delete;

 private:
  bool was_left_out_;
  double before_, start_;  ///< read by the outermost scope only
};

/// Adds the serial_seconds() of a scope to a number of seconds. Within a call that is shared, it
/// counts as if it were outside.
class SerialClock {
 public:
  explicit SerialClock(double& seconds);
  ~SerialClock();
  SerialClock(const SerialClock&) = delete;
  SerialClock& operator=(const SerialClock&) = delete;

 private:
  bool was_left_out_;
  double& seconds_;
  double start_;
};

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
