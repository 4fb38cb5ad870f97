// SPDX-License-Identifier: BSD-3-Clause
//
// Run as several ranks by mpirun: each checks what it gets, and all fail if one does.
#include "surfmesh_mpi/mpi_exchange.hh"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>

#include "support/errors.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh_mpi/mpi_check.hh"
#include "surfmesh_mpi/mpi_session.hh"

namespace surfmesh {
namespace {

/// Numbers that no other rank has, more for higher ranks: none of rank 0.
std::vector<int> numbers_of(int rank) {
  std::vector<int> numbers(static_cast<std::size_t>(1000 * rank));
  std::iota(numbers.begin(), numbers.end(), 1000000 * rank);
  return numbers;
}

TEST(MpiExchange, GathersByRank) {
  MpiExchange exchange;
  const auto gathered = gather_all(exchange, numbers_of(exchange.rank()));
  ASSERT_EQ(gathered.size(), static_cast<std::size_t>(exchange.size()));
  for (int rank = 0; rank < exchange.size(); ++rank) {
    EXPECT_EQ(gathered[static_cast<std::size_t>(rank)], numbers_of(rank));
  }
}

/// As what is longer than MPI counts.
TEST(MpiExchange, GathersInSeveralCalls) {
  for (const std::size_t most : {std::size_t{64}, std::size_t{999}, std::size_t{4096}}) {
    MpiExchange exchange(MPI_COMM_WORLD, most);
    const auto gathered = gather_all(exchange, numbers_of(exchange.rank()));
    for (int rank = 0; rank < exchange.size(); ++rank) {
      EXPECT_EQ(gathered[static_cast<std::size_t>(rank)], numbers_of(rank)) << most;
    }
  }
}

TEST(MpiExchange, GathersNothing) {
  MpiExchange exchange;
  const auto gathered = gather_all(exchange, std::vector<double>());
  EXPECT_EQ(gathered, std::vector<std::vector<double>>(static_cast<std::size_t>(exchange.size())));
}

TEST(MpiExchange, AgreesOnTheErrorOfTheLeastPatch) {
  MpiExchange exchange;
  std::optional<RankError> mine;
  const int last = exchange.size() - 1;
  if (exchange.rank() == last) mine = {2, ErrorCode::Limit, "patch 2"};
  if (exchange.rank() == 0 && last > 0) mine = {5, ErrorCode::Geometry, "patch 5"};
  EXPECT_EQ(error_of([&] { agree_on_error(exchange, mine); }), "limit: patch 2");
}

TEST(MpiExchange, TurnsErrorsOfMpiIntoOurs) {
  const std::string text = error_of([] { detail::check_mpi(MPI_ERR_COMM, "MPI_Something"); });
  EXPECT_TRUE(text.starts_with("io: MPI_Something: ")) << text;
  EXPECT_EQ(error_of([] { detail::check_mpi(MPI_SUCCESS, "MPI_Something"); }), "no error");
}

}  // namespace
}  // namespace surfmesh

int main(int argc, char** argv) {
  const surfmesh::MpiSession session(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  surfmesh::MpiExchange exchange;
  return surfmesh::sum_all(exchange, failed) == 0 ? 0 : 1;
}
