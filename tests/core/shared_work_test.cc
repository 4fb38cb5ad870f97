// SPDX-License-Identifier: BSD-3-Clause
// What threads build together: sums of ranges, buckets, sets.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "surfmesh/core/buckets.hh"
#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/core/shared_sets.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kCount = 50'000;
constexpr int kThreadCounts[] = {1, 2, 8};

TEST(SumOfRanges, IsTheSameToTheLastBitForAnyNumberOfThreads) {
  std::vector<double> sums;
  for (const int threads : kThreadCounts) {
    with_threads(threads, [&] {
      sums.push_back(sum_of_ranges(kCount, [](std::size_t first, std::size_t end) {
        double sum = 0;
        for (std::size_t i = first; i < end; ++i) sum += 1 / static_cast<double>(i + 1);
        return sum;
      }));
    });
  }
  EXPECT_NEAR(sums[0], 11.3970039, 1e-6);  // ln n + 0.5772156649 + 1 / 2n
  EXPECT_EQ(sums[1], sums[0]);
  EXPECT_EQ(sums[2], sums[0]);
}

TEST(SumOfRanges, AddsInTheOrderOfTheRanges) {
  with_threads(8, [] {
    const std::string text = sum_of_ranges(kCount, [](std::size_t first, std::size_t end) {
      return std::to_string(first) + "-" + std::to_string(end) + " ";
    });
    EXPECT_TRUE(text.starts_with("0-4096 4096-8192 ")) << text;
    EXPECT_TRUE(text.ends_with("-50000 ")) << text;
  });
}

TEST(SumOfRanges, OfNothingIsNothing) {
  EXPECT_EQ(sum_of_ranges(0, [](std::size_t, std::size_t) { return 7; }), 0);
}

TEST(SumOfRanges, ThrowsTheErrorOfTheFirstRangeThatFails) {
  const auto fail = [](std::size_t first, std::size_t) {
    if (first > 4096) throw std::runtime_error(std::to_string(first));
    return 0;
  };
  try {
    with_threads(8, [&] { sum_of_ranges(kCount, fail); });
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "8192");
  }
}

TEST(Buckets, HoldEachIndexOnceWithThoseOfTheSameKey) {
  std::vector<std::uint64_t> keys;
  for (std::size_t i = 0; i < kCount; ++i) keys.push_back(Buckets::hash(i % 1000));
  const Buckets buckets(keys);
  std::vector<int> seen(kCount, 0);
  for (std::size_t b = 0; b < Buckets::kCount; ++b) {
    EXPECT_FALSE(buckets[b].empty());
    std::uint32_t least = 0;
    for (const std::uint32_t i : buckets[b]) {
      EXPECT_GE(i, least);
      least = i + 1;
      EXPECT_EQ(Buckets::bucket_of(keys[i]), b);
      ++seen[i];
    }
  }
  EXPECT_EQ(seen, std::vector<int>(kCount, 1));
}

TEST(Buckets, OfNothingAreEmpty) {
  const Buckets buckets({});
  for (std::size_t b = 0; b < Buckets::kCount; ++b) EXPECT_TRUE(buckets[b].empty());
}

TEST(SharedSets, AreJoinedAsOftenAsInOneThread) {
  const auto other_of = [](std::size_t i) { return Buckets::hash(i) % kCount; };
  std::size_t joined = 0;
  DisjointSets alone(kCount);
  for (std::size_t i = 0; i < kCount; i += 2) joined += alone.unite(i, other_of(i)) ? 1 : 0;
  for (const int threads : kThreadCounts) {
    SharedSets sets(kCount);
    with_threads(threads, [&] {
      const std::size_t count = sum_of_ranges(kCount, [&](std::size_t first, std::size_t end) {
        std::size_t own = 0;
        for (std::size_t i = first; i < end; i += 2) own += sets.unite(i, other_of(i)) ? 1 : 0;
        return own;
      });
      EXPECT_EQ(count, joined);
    });
  }
}

}  // namespace
}  // namespace surfmesh
