// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/exchange/exchange.hh"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <stdexcept>

#include "support/thread_exchange.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/exchange/serial_exchange.hh"

namespace surfmesh {
namespace {

using testing::errors_of_ranks;
using testing::run_ranks;

using OfRanks = std::vector<std::vector<int>>;

/// Numbers that no other rank has, as many as the rank: none of rank 0.
std::vector<int> numbers_of(int rank) {
  std::vector<int> numbers(static_cast<std::size_t>(rank));
  std::iota(numbers.begin(), numbers.end(), 100 * rank);
  return numbers;
}

TEST(SerialExchange, GivesBackWhatItIsGiven) {
  SerialExchange exchange;
  EXPECT_EQ(exchange.rank(), 0);
  EXPECT_EQ(exchange.size(), 1);
  EXPECT_EQ(gather_all(exchange, numbers_of(3)), OfRanks{numbers_of(3)});
  EXPECT_EQ(gather_all(exchange, numbers_of(0)), OfRanks{numbers_of(0)});
  EXPECT_EQ(sum_all(exchange, 2.5), 2.5);
  EXPECT_EQ(exchange.bytes_sent(), 0);
}

TEST(ThreadExchange, GathersByRank) {
  for (const int count : {1, 2, 5}) {
    run_ranks(count, [&](Exchange& exchange) {
      ASSERT_EQ(exchange.size(), count);
      const auto gathered = gather_all(exchange, numbers_of(exchange.rank()));
      ASSERT_EQ(gathered.size(), static_cast<std::size_t>(count));
      for (int rank = 0; rank < count; ++rank) {
        EXPECT_EQ(gathered[static_cast<std::size_t>(rank)], numbers_of(rank));
      }
    });
  }
}

/// Ranks that are a round ahead must not change what others still take.
TEST(ThreadExchange, KeepsRoundsApart) {
  run_ranks(3, [](Exchange& exchange) {
    for (int round = 0; round < 2000; ++round) {
      ASSERT_EQ(sum_all(exchange, round + exchange.rank()), 3 * round + 3);
    }
  });
}

TEST(ThreadExchange, CountsWhatEachRankGives) {
  run_ranks(3, [](Exchange& exchange) {
    gather_all(exchange, numbers_of(exchange.rank()));
    gather_one(exchange, 'x');
    EXPECT_EQ(exchange.bytes_sent(), static_cast<std::int64_t>(sizeof(int)) * exchange.rank() + 1);
  });
}

TEST(ThreadExchange, EndsRanksThatWaitForOneThatGaveUp) {
  const auto errors = errors_of_ranks(3, [](Exchange& exchange) {
    if (exchange.rank() == 1) throw Error(ErrorCode::Geometry, "a fault");
    sum_all(exchange, 1);
  });
  for (std::size_t rank = 0; rank < errors.size(); ++rank) {
    ASSERT_TRUE(errors[rank]) << rank;
    try {
      std::rethrow_exception(errors[rank]);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), rank == 1 ? ErrorCode::Geometry : ErrorCode::Io) << rank;
    }
  }
}

TEST(OffsetOfRank, CountsThoseBeforeAndAll) {
  run_ranks(4, [](Exchange& exchange) {
    const std::vector<std::int64_t> counts = {5, 0, 7, 1}, first = {0, 5, 5, 12};
    const auto rank = static_cast<std::size_t>(exchange.rank());
    const RankOffset offset = offset_of_rank(exchange, counts[rank]);
    EXPECT_EQ(offset.first, first[rank]);
    EXPECT_EQ(offset.total, 13);
  });
}

/// The text and code that all ranks agree on, which must be the same; none if there is no error.
std::optional<std::pair<ErrorCode, std::string>> agreed(
    int count, const std::function<void(Exchange&)>& body) {
  std::vector<std::optional<std::pair<ErrorCode, std::string>>> found;
  for (const std::exception_ptr& thrown : errors_of_ranks(count, body)) {
    found.emplace_back();
    if (!thrown) continue;
    try {
      std::rethrow_exception(thrown);
    } catch (const AgreedError& error) {
      found.back() = {error.code(), error.what()};
    }
  }
  for (const auto& of_rank : found) EXPECT_EQ(of_rank, found.front());
  return found.front();
}

TEST(AgreeOnError, LetsAllGoOnWhereThereIsNone) {
  EXPECT_FALSE(agreed(3, [](Exchange& exchange) { agree_on_error(exchange, std::nullopt); }));
}

TEST(AgreeOnError, ThrowsThatOfTheLeastPatchOnAllRanks) {
  const auto error = agreed(4, [](Exchange& exchange) {
    std::optional<RankError> mine;
    if (exchange.rank() == 1) mine = {7, ErrorCode::Geometry, "patch 7"};
    if (exchange.rank() == 3) mine = {4, ErrorCode::Limit, "patch 4"};
    agree_on_error(exchange, mine);
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->first, ErrorCode::Limit);
  EXPECT_EQ(error->second, "patch 4");
}

TEST(AgreeOnError, TakesThatOfTheLeastRankAmongEquals) {
  const auto error = agreed(3, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      if (exchange.rank() == 0) return;
      throw Error(ErrorCode::Io, std::to_string(exchange.rank()));
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->second, "1");
}

TEST(AgreeOnError, TellsOfMemoryThatRanOut) {
  const auto error = agreed(2, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      if (exchange.rank() == 1) throw std::bad_alloc();
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->first, ErrorCode::Limit);
  EXPECT_EQ(error->second, "out of memory");
}

TEST(AgreeOnError, TellsOfAnyException) {
  const auto error = agreed(2, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      if (exchange.rank() == 1) throw std::out_of_range("no such point");
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->first, ErrorCode::InvalidInput);
  EXPECT_EQ(error->second, "no such point");
}

TEST(AgreeOnError, TakesTheIndexOfAnError) {
  const auto error = agreed(3, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      const int rank = exchange.rank();
      throw ErrorAt({10 - rank, ErrorCode::Geometry, std::to_string(rank)});
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->second, "2");
}

TEST(AgreeOnError, LetsACancelledRunCountBeforeAllErrors) {
  const auto error = agreed(3, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      const bool is_cancelled = exchange.rank() == 1;
      throw Error(is_cancelled ? ErrorCode::Cancelled : ErrorCode::Io, "an error");
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->first, ErrorCode::Cancelled);
}

TEST(AgreeOnError, LetsAnAgreedErrorThroughNestedCalls) {
  const auto error = agreed(3, [](Exchange& exchange) {
    agree_on_errors_of(exchange, [&] {
      agree_on_errors_of(exchange, [&] {
        if (exchange.rank() == 2) throw Error(ErrorCode::Geometry, "inner");
      });
    });
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(error->second, "inner");
}

}  // namespace
}  // namespace surfmesh
