// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/parallel.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace surfmesh {
namespace {

/// The threads that work on many calls, each of some milliseconds.
std::set<std::thread::id> threads_at_work(int threads) {
  std::set<std::thread::id> ids;
  std::mutex mutex;
  with_threads(threads, [&] {
    share_indices(64, [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      const std::lock_guard lock(mutex);
      ids.insert(std::this_thread::get_id());
    });
  });
  return ids;
}

/// Work that the processor feels.
void spend(double seconds) {
  const double start = processor_seconds();
  while (processor_seconds() - start < seconds) {
  }
}

TEST(ShareIndices, CallsForEachIndexOnce) {
  for (const int threads : {0, 1, 2, 8}) {
    std::vector<std::atomic<int>> calls(1000);
    with_threads(threads, [&] { share_indices(calls.size(), [&](std::size_t i) { ++calls[i]; }); });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(ShareIndices, StaysInTheCallingThreadIfItIsTheOnlyOne) {
  EXPECT_EQ(threads_at_work(1), std::set{std::this_thread::get_id()});
}

TEST(ShareIndices, StaysThereIfMoreThreadsAreAskedForWithin) {
  with_threads(1, [] { EXPECT_EQ(threads_at_work(8), std::set{std::this_thread::get_id()}); });
  EXPECT_GT(threads_at_work(8).size(), 1u);
}

TEST(ShareIndices, TakesMoreThreadsThanCoresIfAskedFor) {
  const std::size_t count = threads_at_work(8).size();
  EXPECT_GT(count, 1u);
  EXPECT_LE(count, 8u);
}

TEST(ShareIndices, ThrowsTheErrorOfTheFirstIndex) {
  for (const int threads : {1, 2, 8}) {
    const auto fail_from_ten = [](std::size_t i) {
      if (i >= 10) throw std::runtime_error(std::to_string(i));
    };
    std::vector<std::size_t> backwards(100);
    std::iota(backwards.rbegin(), backwards.rend(), std::size_t{0});
    try {
      with_threads(threads, [&] { share_indices(backwards, fail_from_ten); });
      ADD_FAILURE() << "no error";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "10");
    }
  }
}

TEST(ShareIndices, MayBeCalledWithinASharedCall) {
  std::atomic<int> calls = 0;
  with_threads(4, [&] {
    share_indices(8, [&](std::size_t) { share_indices(8, [&](std::size_t) { ++calls; }); });
  });
  EXPECT_EQ(calls, 64);
}

TEST(ShareRanges, CoversAllIndicesByTheSamePartsForAnyNumberOfThreads) {
  std::vector<std::vector<std::size_t>> parts;
  for (const int threads : {1, 2, 8}) {
    std::vector<std::size_t> part_of(10'000, 0);
    with_threads(threads, [&] {
      share_ranges(part_of.size(), [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) part_of[i] += end;
      });
    });
    parts.push_back(part_of);
  }
  EXPECT_EQ(parts[0].back(), parts[0].size());
  EXPECT_EQ(parts[1], parts[0]);
  EXPECT_EQ(parts[2], parts[0]);
}

TEST(HeaviestFirst, KeepsTheOrderOfEqualOnes) {
  EXPECT_EQ(heaviest_first({1, 5, 3, 5}), (std::vector<std::size_t>{1, 3, 2, 0}));
}

TEST(ProcessorSeconds, CountsTheTimeOfAllThreads) {
  constexpr double each = 0.01;
  for (const int threads : {1, 4}) {
    double seconds = 0;
    with_threads(threads, [&] {
      const StageClock clock(seconds);
      share_indices(8, [](std::size_t) { spend(each); });
    });
    EXPECT_GE(seconds, 8 * each);
    EXPECT_LT(seconds, 16 * each);
  }
}

/// The serial seconds of work of 0.02 s outside of calls that share, of which `work` has more.
template <class Work>
double serial_seconds_of(int threads, Work work) {
  double seconds = 0;
  with_threads(threads, [&] {
    const SerialClock clock(seconds);
    spend(0.02);
    work();
  });
  return seconds;
}

TEST(SerialClock, LeavesOutWhatIsShared) {
  for (const int threads : {1, 4}) {
    const double seconds =
        serial_seconds_of(threads, [] { share_indices(8, [](std::size_t) { spend(0.02); }); });
    EXPECT_GE(seconds, 0.02);
    EXPECT_LT(seconds, 0.04);
  }
}

TEST(SerialClock, LeavesOutCallsWithinSharedCalls) {
  for (const int threads : {1, 4}) {
    const double seconds = serial_seconds_of(threads, [] {
      share_indices(4, [](std::size_t) {
        share_indices(2, [](std::size_t) { spend(0.01); });
        spend(0.01);
      });
    });
    EXPECT_GE(seconds, 0.02);
    EXPECT_LT(seconds, 0.04);
  }
}

TEST(SerialClock, LeavesOutScopesAndWhatFails) {
  const double seconds = serial_seconds_of(1, [] {
    {
      const LeftOutOfSerial left_out;
      spend(0.02);
      share_indices(1, [](std::size_t) { spend(0.01); });
    }
    const auto fail = [](std::size_t) {
      spend(0.02);
      throw std::runtime_error("");
    };
    EXPECT_THROW(share_indices(1, fail), std::runtime_error);
    spend(0.02);
  });
  EXPECT_GE(seconds, 0.04);
  EXPECT_LT(seconds, 0.06);
}

TEST(SerialClock, CountsWithinASharedCallAsOutsideOfIt) {
  double outer = 0;
  {
    const SerialClock clock(outer);
    share_indices(1, [](std::size_t) {
      const double inner =
          serial_seconds_of(1, [] { share_indices(1, [](std::size_t) { spend(0.04); }); });
      EXPECT_GE(inner, 0.02);
      EXPECT_LT(inner, 0.04);
    });
  }
  EXPECT_LT(outer, 0.02);
}

}  // namespace
}  // namespace surfmesh
