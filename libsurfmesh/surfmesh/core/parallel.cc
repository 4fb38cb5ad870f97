// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/parallel.hh"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

#include "surfmesh/core/threads.hh"

namespace surfmesh {
namespace {

constexpr double kNanosecond = 1e-9;

/// Indices of a part of share_ranges: much longer to work on than to hand out.
constexpr std::size_t kRange = 4096;

/// Of calls that this thread has shared with others, what they spent on them.
thread_local double seconds_of_others = 0;

/// Of the time of this thread and of seconds_of_others, what was spent in calls that share.
thread_local double seconds_left_out = 0;

/// True in a call that shares, with one thread, too.
thread_local bool is_left_out = false;

/// True in a call that is shared.
thread_local bool is_in_shared_call = false;

/// A call that is shared, for as long as this lives.
class SharedCall {
 public:
  SharedCall() : was_in_one_(std::exchange(is_in_shared_call, true)) {}
  ~SharedCall() { is_in_shared_call = was_in_one_; }
  SharedCall(const SharedCall&) = delete;
  SharedCall& operator=(const SharedCall&) = delete;

 private:
  bool was_in_one_;
};

double seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + kNanosecond * static_cast<double>(now.tv_nsec);
}

/// Indices that threads take one after the other.
class SharedIndices {
 public:
  SharedIndices(const std::vector<std::size_t>& indices,
                const std::function<void(std::size_t)>& body)
      : indices_(indices), body_(body), first_failed_(indices.size()) {}

  void run(int threads) {
    share(threads);
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void share(int threads) {
    const LeftOutOfSerial loop;
    if (threads == 1) {
      run_remaining();
    } else {
      detail::run_at_once(threads, [this] { work(); });
    }
    seconds_of_others += seconds_;
  }

  void work() {
    const double start = seconds_of_this_thread();
    {
      const SharedCall shared;
      const LeftOutOfSerial loop;
      run_remaining();
    }
    if (std::this_thread::get_id() == caller_) return;
    const std::lock_guard lock(mutex_);
    seconds_ += seconds_of_this_thread() - start;
  }

  void run_remaining() {
    for (std::size_t i = next_++; i < indices_.size(); i = next_++) take(indices_[i]);
  }

  void take(std::size_t index) {
    if (index > first_failed_) return;
    try {
      body_(index);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (index > first_failed_) return;
      first_failed_ = index;
      error_ = std::current_exception();
    }
  }

  const std::vector<std::size_t>& indices_;
  const std::function<void(std::size_t)>& body_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> first_failed_;  ///< the number of indices while none has
  std::mutex mutex_;
  std::exception_ptr error_;
  double seconds_ = 0;  ///< of other threads than the caller
};

/// Run `body` in this thread as if its calls were shared already. No other thread is needed, so
/// oneTBB is not asked: to start costs it a millisecond.
void run_alone(const std::function<void()>& body) {
  const SharedCall alone;
  body();
}

}  // namespace

void with_threads(int threads, const std::function<void()>& body) {
  if (threads == 1) return run_alone(body);
  detail::with_thread_limit(threads, body);
}

void share_indices(const std::vector<std::size_t>& indices,
                   const std::function<void(std::size_t)>& body) {
  if (indices.empty()) return;
  const int threads = is_in_shared_call ? 1 : detail::thread_limit();
  SharedIndices(indices, body)
      .run(static_cast<int>(std::min(static_cast<std::size_t>(threads), indices.size())));
}

void share_indices(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  share_indices(indices, body);
}

void share_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) {
  share_indices((count + kRange - 1) / kRange, [&](std::size_t part) {
    body(part * kRange, std::min(count, (part + 1) * kRange));
  });
}

std::vector<std::size_t> heaviest_first(const std::vector<std::size_t>& weights) {
  std::vector<std::size_t> indices(weights.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::stable_sort(indices.begin(), indices.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  return indices;
}

double processor_seconds() { return seconds_of_this_thread() + seconds_of_others; }

double serial_seconds() { return processor_seconds() - seconds_left_out; }

LeftOutOfSerial::LeftOutOfSerial()
    : was_left_out_(std::exchange(is_left_out, true)),
      before_(seconds_left_out),
      start_(was_left_out_ ? 0 : processor_seconds()) {}

LeftOutOfSerial::~LeftOutOfSerial() {
  if (was_left_out_) return;
  is_left_out = false;
  // Not added: a SerialClock within has counted a part of it already.
  seconds_left_out = before_ + (processor_seconds() - start_);
}

SerialClock::SerialClock(double& seconds)
    : was_left_out_(std::exchange(is_left_out, false)),
      seconds_(seconds),
      start_(serial_seconds()) {}

SerialClock::~SerialClock() {
  seconds_ += serial_seconds() - start_;
  is_left_out = was_left_out_;
}

}  // namespace surfmesh
