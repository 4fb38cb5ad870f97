// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/exchange/exchange.hh"

namespace surfmesh::testing {

/// Where threads that are ranks of one run meet.
class ThreadMeeting {
 public:
  using Bytes = std::vector<std::byte>;

  explicit ThreadMeeting(int size) : arriving_(static_cast<std::size_t>(size)) {}

  int size() const { return static_cast<int>(arriving_.size()); }

  /// Wait until all ranks are here. Returns what they brought.
  /// Throws   Io if one has left
  std::vector<Bytes> meet(int rank, Bytes mine) {
    std::unique_lock lock(mutex_);
    arriving_[static_cast<std::size_t>(rank)] = std::move(mine);
    const int round = round_;
    if (++arrived_ == size()) {
      // Nobody takes part in the next round before it has left this one.
      gathered_ = arriving_;
      arrived_ = 0;
      ++round_;
      all_here_.notify_all();
    }
    all_here_.wait(lock, [&] { return round_ != round || has_lost_one_; });
    if (round_ == round) throw Error(ErrorCode::Io, "another rank has ended");
    return gathered_;
  }

  /// A rank does not come any more; what others still wait for does not happen.
  void leave() {
    const std::lock_guard lock(mutex_);
    has_lost_one_ = true;
    all_here_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_here_;
  std::vector<Bytes> arriving_, gathered_;
  int arrived_ = 0;
  int round_ = 0;
  bool has_lost_one_ = false;
};

/// A rank that is a thread.
class ThreadExchange final : public Exchange {
 public:
  ThreadExchange(ThreadMeeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}

  int rank() const override { return rank_; }
  int size() const override { return meeting_.size(); }

 private:
  std::vector<std::vector<std::byte>> gather(std::span<const std::byte> mine) override {
    return meeting_.meet(rank_, {mine.begin(), mine.end()});
  }

  ThreadMeeting& meeting_;
  int rank_;
};

/// Call `body(exchange)` as each of `count` ranks, at the same time.
/// Returns  by rank, what was thrown; null for nothing. Ranks that waited for one that threw, or
///          returned too early, have an Error of code Io
inline std::vector<std::exception_ptr> errors_of_ranks(int count,
                                                       const std::function<void(Exchange&)>& body) {
  ThreadMeeting meeting(count);
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(count));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < count; ++rank) {
    threads.emplace_back([&, rank] {
      ThreadExchange exchange(meeting, rank);
      try {
        body(exchange);
      } catch (...) {
        errors[static_cast<std::size_t>(rank)] = std::current_exception();
      }
      meeting.leave();
    });
  }
  for (std::thread& thread : threads) thread.join();
  return errors;
}

/// Likewise.
/// Throws   what the first rank threw that threw anything
inline void run_ranks(int count, const std::function<void(Exchange&)>& body) {
  for (const std::exception_ptr& error : errors_of_ranks(count, body)) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace surfmesh::testing
